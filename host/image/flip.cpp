#include "image/flip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <utility>

namespace lacquer {

namespace {

constexpr double kPi = std::numbers::pi;

template <typename Value>
struct Plane {
    int width, height;
    std::vector<Value> values;

    // The nearest pixel of the picture.
    const Value& at(int x, int y) const {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return values[static_cast<std::size_t>(y * width + x)];
    }
};

// Weights of the neighbours up to `radius` away, row by row.
template <typename Weight>
struct Kernel {
    int radius;
    std::vector<Weight> weights;
};

template <typename Weight>
Kernel<Weight> make_kernel(int radius, const std::function<Weight(int x, int y)>& weight) {
    Kernel<Weight> kernel{radius, {}};
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) kernel.weights.push_back(weight(x, y));
    return kernel;
}

// `Weight` times `Value` is a Weight.
template <typename Weight, typename Value>
Plane<Weight> convolved(const Plane<Value>& plane, const Kernel<Weight>& kernel) {
    Plane<Weight> result{plane.width, plane.height, {}};
    result.values.reserve(plane.values.size());
    for (int y = 0; y < plane.height; ++y)
        for (int x = 0; x < plane.width; ++x) {
            Weight sum{0.0};
            std::size_t n = 0;
            for (int dy = -kernel.radius; dy <= kernel.radius; ++dy)
                for (int dx = -kernel.radius; dx <= kernel.radius; ++dx)
                    sum += kernel.weights[n++] * plane.at(x + dx, y + dy);
            result.values.push_back(sum);
        }
    return result;
}

// Linear sRGB to CIE XYZ, relative to D65 white, which is sRGB's.
glm::dmat3 make_relative_xyz() {
    // IEC 61966-2-1, rows X, Y, Z.
    const glm::dmat3 rows{{0.4124, 0.3576, 0.1805},   //
                          {0.2126, 0.7152, 0.0722},   //
                          {0.0193, 0.1192, 0.9505}};  //
    const glm::dvec3 white = glm::dvec3{1.0} * rows;
    glm::dmat3 relative = glm::transpose(rows);
    for (int column = 0; column < 3; ++column) relative[column] /= white;
    return relative;
}

const glm::dmat3& relative_xyz() {
    static const glm::dmat3 kMatrix = make_relative_xyz();
    return kMatrix;
}

// The opponent space in which contrast is seen, linear in light (section 4.1.1).
glm::dvec3 ycxcz_of(const glm::dvec3& xyz) {
    return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 xyz_of(const glm::dvec3& ycxcz) {
    const double y = (ycxcz.x + 16.0) / 116.0;
    return {y + ycxcz.y / 500.0, y, y - ycxcz.z / 200.0};
}

// CIELAB with Hunt's adjustment: dark colours have less chroma (section 4.1.2).
glm::dvec3 hunt_lab_of(const glm::dvec3& linear) {
    constexpr double kDelta = 6.0 / 29.0;
    const auto compressed = [](double t) {
        return t > kDelta * kDelta * kDelta ? std::cbrt(t)
                                            : t / (3.0 * kDelta * kDelta) + 4.0 / 29.0;
    };
    const glm::dvec3 xyz = relative_xyz() * linear;
    const double x = compressed(xyz.x), y = compressed(xyz.y), z = compressed(xyz.z);
    const double lightness = 116.0 * y - 16.0, hunt = 0.01 * lightness;
    return {lightness, hunt * 500.0 * (x - y), hunt * 200.0 * (y - z)};
}

// The distance HyAB of large colour differences, compressed (section 4.1.3).
double color_distance(const glm::dvec3& linear, const glm::dvec3& other) {
    constexpr double kExponent = 0.7;
    const glm::dvec3 difference = hunt_lab_of(linear) - hunt_lab_of(other);
    return std::pow(std::abs(difference.x) + glm::length(glm::dvec2{difference.y, difference.z}),
                    kExponent);
}

// To [0, 1]: most of it for the smaller ones of the differences there are.
double color_error(double distance) {
    constexpr double kShare = 0.4, kError = 0.95;
    static const double kLargest = color_distance({0.0, 1.0, 0.0}, {0.0, 0.0, 1.0});
    const double bend = kShare * kLargest;
    return distance < bend ? kError / bend * distance
                           : kError + (distance - bend) / (kLargest - bend) * (1.0 - kError);
}

// The eye's sensitivity to contrast as a sum of Gaussians, per channel of YCxCz (section 4.1.1).
Kernel<glm::dvec3> contrast_sensitivity(double pixels_per_degree) {
    constexpr double kWidest = 0.04;
    const int radius = static_cast<int>(
        std::ceil(3.0 * std::sqrt(kWidest / (2.0 * kPi * kPi)) * pixels_per_degree));
    auto kernel = make_kernel<glm::dvec3>(radius, [&](int x, int y) {
        const double degrees2 = (x * x + y * y) / (pixels_per_degree * pixels_per_degree);
        const auto gaussian = [&](double a, double b) {
            return a * std::sqrt(kPi / b) * std::exp(-kPi * kPi * degrees2 / b);
        };
        return glm::dvec3{gaussian(1.0, 0.0047), gaussian(1.0, 0.0053),
                          gaussian(34.1, kWidest) + gaussian(13.5, 0.025)};
    });
    glm::dvec3 sum{0.0};
    for (const glm::dvec3& weight : kernel.weights) sum += weight;
    for (glm::dvec3& weight : kernel.weights) weight /= sum;
    return kernel;
}

enum class Feature { edge, point };

// What detects a feature along x, and along y (section 4.2): its positive weights sum to 1, its
// negative ones to -1.
Kernel<glm::dvec2> feature_detector(Feature feature, double pixels_per_degree) {
    constexpr double kWidth_deg = 0.082;
    const double deviation = 0.5 * kWidth_deg * pixels_per_degree;
    const auto weight = [&](int x, int y) {
        const double gaussian = std::exp(-(x * x + y * y) / (2.0 * deviation * deviation));
        return feature == Feature::edge ? -x * gaussian
                                        : (x * x / (deviation * deviation) - 1.0) * gaussian;
    };
    const int radius = static_cast<int>(std::ceil(3.0 * deviation));
    auto kernel = make_kernel<glm::dvec2>(radius, [&](int x, int y) {
        return glm::dvec2{weight(x, y), weight(y, x)};
    });
    double above = 0.0, below = 0.0;
    for (const glm::dvec2& one : kernel.weights) (one.x > 0.0 ? above : below) += std::abs(one.x);
    for (glm::dvec2& one : kernel.weights)
        for (int axis = 0; axis < 2; ++axis) one[axis] /= one[axis] > 0.0 ? above : below;
    return kernel;
}

// A picture in YCxCz.
Plane<glm::dvec3> opponents_of(std::span<const DisplayColor> colors, int width) {
    Plane<glm::dvec3> plane{width, static_cast<int>(colors.size()) / width, {}};
    for (const DisplayColor& color : colors) {
        const auto linear = [](std::uint8_t level) { return srgb_decode(level / 255.0); };
        plane.values.push_back(ycxcz_of(
            relative_xyz() * glm::dvec3{linear(color.r), linear(color.g), linear(color.b)}));
    }
    return plane;
}

// What is seen of the colours, in linear sRGB.
std::vector<glm::dvec3> seen_colors(const Plane<glm::dvec3>& opponents,
                                    const Kernel<glm::dvec3>& sensitivity) {
    static const glm::dmat3 kToLinear = glm::inverse(relative_xyz());
    std::vector<glm::dvec3> colors;
    for (const glm::dvec3& ycxcz : convolved(opponents, sensitivity).values)
        colors.push_back(glm::clamp(kToLinear * xyz_of(ycxcz), 0.0, 1.0));
    return colors;
}

Plane<double> luminance_of(const Plane<glm::dvec3>& opponents) {
    Plane<double> luminance{opponents.width, opponents.height, {}};
    for (const glm::dvec3& ycxcz : opponents.values) luminance.values.push_back(xyz_of(ycxcz).y);
    return luminance;
}

// How much more of a feature the one picture has than the other.
std::vector<double> feature_differences(const Plane<double>& reference, const Plane<double>& test,
                                        const Kernel<glm::dvec2>& detector) {
    const auto one = convolved(reference, detector), other = convolved(test, detector);
    std::vector<double> differences;
    for (std::size_t n = 0; n < one.values.size(); ++n)
        differences.push_back(std::abs(glm::length(one.values[n]) - glm::length(other.values[n])));
    return differences;
}

}  // namespace

std::vector<double> flip(std::span<const DisplayColor> reference,
                         std::span<const DisplayColor> test, int width, double pixels_per_degree) {
    assert(reference.size() == test.size() && width > 0 && reference.size() % width == 0);
    const auto sensitivity = contrast_sensitivity(pixels_per_degree);
    const auto first = opponents_of(reference, width), second = opponents_of(test, width);
    const auto seen = seen_colors(first, sensitivity), other = seen_colors(second, sensitivity);
    const auto differences_of = [&](Feature feature) {
        return feature_differences(luminance_of(first), luminance_of(second),
                                   feature_detector(feature, pixels_per_degree));
    };
    const auto edges = differences_of(Feature::edge), points = differences_of(Feature::point);
    std::vector<double> result;
    result.reserve(seen.size());
    for (std::size_t n = 0; n < seen.size(); ++n) {
        const double feature = std::sqrt(std::max(edges[n], points[n]) / std::numbers::sqrt2);
        result.push_back(
            std::pow(color_error(color_distance(seen[n], other[n])), 1.0 - std::min(feature, 1.0)));
    }
    return result;
}

}  // namespace lacquer
