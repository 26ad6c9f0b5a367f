// Integrals over directions in polar coordinates about the normal, which the reference itself does
// not use.
#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <glm/vec3.hpp>
#include <numbers>
#include <vector>

namespace lacquer::test {

// Exact for polynomials up to degree 19.
using Panel = boost::math::quadrature::gauss<double, 10>;

using Quadrature = boost::math::quadrature::gauss_kronrod<double, 15>;

inline glm::dvec3 direction(double cos_theta, double phi) {
    const double sin_theta = std::sqrt((1.0 - cos_theta) * (1.0 + cos_theta));
    return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), cos_theta};
}

// Integral over [breaks.front(), breaks.back()] of f, which may have peaks or kinks at the breaks.
template <typename Function>
double integrate_between(const Function& f, const std::vector<double>& breaks, double tolerance) {
    constexpr unsigned kMaxHalvings = 10;
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        if (breaks[i + 1] > breaks[i])
            sum += Quadrature::integrate(f, breaks[i], breaks[i + 1], kMaxHalvings, tolerance);
    return sum;
}

// Ends of panels from `low` to `high`, fine around `peak`, whose width is `width`.
inline std::vector<double> panels(double low, double high, double peak, double width) {
    std::vector<double> breaks{low, high};
    for (int i = 1; i < 8; ++i) breaks.push_back(low + i * (high - low) / 8);
    for (const double distance : {0.0, 0.3, 1.0, 3.0, 10.0})
        for (const double side : {-1.0, 1.0})
            breaks.push_back(std::clamp(peak + side * distance * width, low, high));
    std::ranges::sort(breaks);
    return breaks;
}

// Integral per solid angle of f(w) over low < theta < high, for f with a peak of about `width`
// radians around `peak`: a product of panels in polar coordinates about the normal.
template <typename Function>
double integrate_zone(const Function& f, double low, double high, const glm::dvec3& peak,
                      double width) {
    const auto over = [](const auto& g, const std::vector<double>& breaks) {
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
            if (breaks[i + 1] > breaks[i]) sum += Panel::integrate(g, breaks[i], breaks[i + 1]);
        return sum;
    };
    const double phi_peak = std::atan2(peak.y, peak.x);
    const std::vector<double> phis =
        panels(phi_peak - std::numbers::pi, phi_peak + std::numbers::pi, phi_peak, width);
    const auto ring = [&](double theta) {
        const auto at = [&](double phi) { return f(direction(std::cos(theta), phi)); };
        return std::sin(theta) * over(at, phis);
    };
    return over(ring, panels(low, high, std::acos(std::clamp(peak.z, -1.0, 1.0)), width));
}

template <typename Function>
double integrate_hemisphere(const Function& f, const glm::dvec3& peak, double width) {
    return integrate_zone(f, 0.0, std::numbers::pi / 2, peak, width);
}

}  // namespace lacquer::test
