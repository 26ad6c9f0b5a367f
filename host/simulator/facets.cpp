#include "simulator/facets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::simulator {

namespace {

constexpr double kPi = std::numbers::pi;

// A facet exactly edge-on or a direction exactly along the plane: 0 / 0 without it.
constexpr double kTiny = 1e-300;

// Smith's Lambda above the surface as a function of a = cot(theta) / alpha(phi).
double lambda_above(Ndf ndf, double a) {
    if (ndf == Ndf::ggx) return 0.5 * (std::sqrt(1.0 + 1.0 / (a * a)) - 1.0);
    if (a > 6.0) return 0.0;  // below 1e-17
    return std::exp(-a * a) / (2.0 * a * std::sqrt(kPi)) - 0.5 * std::erfc(a);
}

// The direction in the space where the population is isotropic with alpha 1.
Vec3 stretch(const Facets& facets, const Vec3& w) {
    return glm::normalize(Vec3{facets.alpha_x * w.x, facets.alpha_y * w.y, w.z});
}

// GGX facets of alpha 1 are the upper half of a sphere: the point that a ray from w meets projects
// uniformly onto the disk across w, cut by the equator.
// Based on: Heitz 2018, Sampling the GGX Distribution of Visible Normals
Vec3 sample_ggx(const Vec3& w, RandomStream& random) {
    const double horizontal = w.x * w.x + w.y * w.y;
    const Vec3 across =
        horizontal > kTiny ? Vec3{-w.y, w.x, 0.0} / std::sqrt(horizontal) : Vec3{1.0, 0.0, 0.0};
    const Vec3 upward = glm::cross(w, across);
    const double radius = std::sqrt(random.uniform());
    const double phi = 2.0 * kPi * random.uniform();
    const double x = radius * std::cos(phi);
    const double chord = std::sqrt(std::max(0.0, 1.0 - x * x));
    // The visible part of the disk at x: a chord whose lower half is squeezed by the cosine.
    const double share = 0.5 * (1.0 + w.z);
    const double y = (1.0 - share) * chord + share * radius * std::sin(phi);
    const double z = std::sqrt(std::max(0.0, 1.0 - x * x - y * y));
    return across * x + upward * y + w * z;
}

// Slope s along w of a Beckmann facet of alpha 1: density proportional to
// max(0, cos - s sin) exp(-s^2). Rejection: from above, out of cos exp(-s^2) + sin |s| exp(-s^2),
// accepting at least half; from below, out of the tail of s exp(-s^2).
double sample_beckmann_slope(double cosine, double sine, RandomStream& random) {
    if (cosine >= 0.0) {
        const double bell = cosine * std::sqrt(kPi);
        for (;;) {
            double slope = 0.0;
            const double pick = random.uniform() * (bell + sine);
            const double radius = std::sqrt(-std::log(random.uniform()));
            if (pick < bell) {
                slope = radius * std::cos(2.0 * kPi * random.uniform());
            } else {
                slope = random.uniform() < 0.5 ? radius : -radius;
            }
            const double wanted = cosine - slope * sine;
            const double proposed = cosine + std::abs(slope) * sine;
            if (random.uniform() * proposed < wanted) return slope;
        }
    }
    const double start = -cosine / sine;
    for (;;) {
        const double depth = std::sqrt(start * start - std::log(random.uniform()));
        if (random.uniform() * depth < depth - start) return -depth;
    }
}

Vec3 sample_beckmann(const Vec3& w, RandomStream& random) {
    const double sine = std::sqrt(w.x * w.x + w.y * w.y);
    const double cos_phi = sine > 0.0 ? w.x / sine : 1.0;
    const double sin_phi = sine > 0.0 ? w.y / sine : 0.0;
    const double along = sample_beckmann_slope(w.z, sine, random);
    const double across =
        std::sqrt(-std::log(random.uniform())) * std::cos(2.0 * kPi * random.uniform());
    return {-(cos_phi * along - sin_phi * across), -(sin_phi * along + cos_phi * across), 1.0};
}

}  // namespace

double smith_lambda(const Facets& facets, const Vec3& w) {
    const double x = facets.alpha_x * w.x;
    const double y = facets.alpha_y * w.y;
    const double a = std::abs(w.z) / std::sqrt(std::max(x * x + y * y, kTiny));
    const double above = lambda_above(facets.ndf, std::max(a, 1e-150));
    return w.z >= 0.0 ? above : -1.0 - above;
}

double projected_area(const Facets& facets, const Vec3& w) {
    const double lambda = smith_lambda(facets, w);
    return w.z * (1.0 + lambda);
}

Vec3 sample_visible_normal(const Facets& facets, const Vec3& w, RandomStream& random) {
    const Vec3 stretched = stretch(facets, w);
    const Vec3 normal =
        facets.ndf == Ndf::ggx ? sample_ggx(stretched, random) : sample_beckmann(stretched, random);
    return glm::normalize(
        Vec3{facets.alpha_x * normal.x, facets.alpha_y * normal.y, std::max(normal.z, 0.0)});
}

}  // namespace lacquer::simulator
