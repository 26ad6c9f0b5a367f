#include "reference/beckmann.h"

#include <algorithm>
#include <boost/math/special_functions/erf.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::reference::beckmann {

namespace {

using std::numbers::inv_sqrtpi;

// Slopes beyond this are met with a probability below exp(-36) = 2e-16: the slope that a uniform
// number of exactly 0 stands for is put here instead of at infinity.
constexpr double kMaxSlope = 6.0;

// More than any bracketed root of a smooth function needs.
constexpr std::uintmax_t kMaxIterations = 100;

// Visible area of all facets whose slope along the view is at most s: the integral up to s of
// (cos_theta - s' sin_theta) exp(-s'^2) / sqrt(pi).
double visible_area(double s, double sin_theta, double cos_theta) {
    return 0.5 * cos_theta * std::erfc(-s) + 0.5 * inv_sqrtpi * sin_theta * std::exp(-s * s);
}

// The slope at which that area is the fraction u of all of it. Facets steeper than cot(theta) turn
// their backs on the view.
double sample_slope_along(double sin_theta, double cos_theta, double u) {
    const double last = sin_theta * kMaxSlope > cos_theta ? cos_theta / sin_theta : kMaxSlope;
    const double wanted = u * visible_area(last, sin_theta, cos_theta);
    const auto excess = [&](double s) { return visible_area(s, sin_theta, cos_theta) - wanted; };
    const double excess_first = excess(-kMaxSlope);
    const double excess_last = excess(last);
    if (excess_first >= 0.0) return -kMaxSlope;
    if (excess_last <= 0.0) return last;
    std::uintmax_t iterations = kMaxIterations;
    const auto [low, high] =
        boost::math::tools::toms748_solve(excess, -kMaxSlope, last, excess_first, excess_last,
                                          boost::math::tools::eps_tolerance<double>(), iterations);
    return 0.5 * (low + high);
}

double sample_slope_across(double u) {
    const double limit = std::erf(kMaxSlope - 0.5);  // below 1, so that its inverse exists
    return boost::math::erf_inv(std::clamp(2.0 * u - 1.0, -limit, limit));
}

}  // namespace

double slope_density(double slope) {
    return std::numbers::inv_pi * std::exp(-slope * slope);
}

double lambda(double a) {
    return 0.5 * (std::exp(-a * a) * inv_sqrtpi / a - std::erfc(a));
}

glm::dvec3 sample_visible_normal(const glm::dvec3& w, const glm::dvec2& u) {
    const double sin_theta = std::hypot(w.x, w.y);
    // A negative 0 has an azimuth too, which would turn the x axis around.
    const double phi = sin_theta > 0.0 ? std::atan2(w.y, w.x) : 0.0;
    const double along = sample_slope_along(sin_theta, w.z, u.x);
    const double across = sample_slope_across(u.y);
    const double slope_x = std::cos(phi) * along - std::sin(phi) * across;
    const double slope_y = std::sin(phi) * along + std::cos(phi) * across;
    return glm::normalize(glm::dvec3{-slope_x, -slope_y, 1.0});
}

}  // namespace lacquer::reference::beckmann
