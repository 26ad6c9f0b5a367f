#include "reference/microsurface/facet_integral.h"

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::reference {

namespace {

using std::numbers::pi;
using Quadrature = boost::math::quadrature::gauss_kronrod<double, 21>;

// The inner integral is a step finer than the outer one, which would take its error for structure.
constexpr double kOuterTolerance = 1e-6;
constexpr double kInnerTolerance = 1e-7;
constexpr unsigned kMaxHalvings = 8;

// Facets of one azimuth: dot(wo, wm) is `most` times the cosine of the tilt beyond `facing`.
struct Azimuth {
    double along;  // cosine between the azimuth and wo
    double facing, most;
};

Azimuth azimuth_of(const glm::dvec3& wo, const glm::dvec2& azimuth) {
    const double along = glm::dot(azimuth, glm::dvec2{wo.x, wo.y});
    return {along, std::atan2(along, wo.z), std::hypot(along, wo.z)};
}

double critical_cosine(double eta) {
    return std::sqrt((1.0 - eta) * (1.0 + eta));
}

// Points crowd at both ends, where the integrand may be like a root.
template <typename Function>
double integrate_arch(const Function& f, double low, double high) {
    const auto smoothed = [&](double t) {
        return 6.0 * t * (1.0 - t) * f(low + (high - low) * t * t * (3.0 - 2.0 * t));
    };
    return (high - low) * Quadrature::integrate(smoothed, 0.0, 1.0, kMaxHalvings, kInnerTolerance);
}

}  // namespace

// Over facet slopes in polar coordinates whose radius is tan(x) in units of alpha: the integrand is
// then smooth at every roughness. D d wm is the density of slopes / wm.z.
double facet_integral(const Facets& facets, const glm::dvec3& wo, const TiltBreaks& breaks,
                      const std::function<double(const glm::dvec3& wm, double cos_theta)>& f) {
    const auto along_ray = [&](double psi) {
        const glm::dvec2 unit{facets.alpha_x * std::cos(psi), facets.alpha_y * std::sin(psi)};
        const double length = glm::length(unit);
        const auto integrand = [&](double x) {
            const double steepness = std::tan(x);
            const glm::dvec3 wm = glm::normalize(glm::dvec3{steepness * unit, 1.0});
            const double cos_theta = glm::dot(wo, wm);
            if (cos_theta <= 0.0) return 0.0;  // rounding at the end of an interval
            return slope_density(facets.ndf, steepness) * steepness *
                   (1.0 + steepness * steepness) * f(wm, cos_theta) * cos_theta / (wm.z * wo.z);
        };
        const std::vector<double> tilts = breaks(unit / length);
        double sum = 0.0;
        for (std::size_t i = 0; i + 1 < tilts.size(); ++i) {
            const double low = std::atan(std::tan(tilts[i]) / length);
            const double high = std::atan(std::tan(tilts[i + 1]) / length);
            if (high > low) sum += integrate_arch(integrand, low, high);
        }
        return sum;
    };
    // From the azimuth of wo, so that symmetric halves split at a node.
    const double start = std::atan2(facets.alpha_y * wo.y, facets.alpha_x * wo.x);
    return Quadrature::integrate(along_ray, start, start + 2.0 * pi, kMaxHalvings, kOuterTolerance);
}

// Facets of slope tan(tilt) mirror wo to the horizon where
//     tan^2 - 2 tan along / wo.z = 1.
std::vector<double> reflecting_tilts(const glm::dvec3& wo, const glm::dvec2& azimuth, double eta) {
    const auto [along, facing, most] = azimuth_of(wo, azimuth);
    const double root = std::hypot(along, wo.z);
    // Both are the positive solution; each is free of cancellation for its sign of `along`.
    const double steepest = std::atan(along > 0.0 ? (along + root) / wo.z : wo.z / (root - along));
    if (eta >= 1.0 || most <= critical_cosine(eta)) return {0.0, steepest};
    const double reach = std::acos(critical_cosine(eta) / most);
    return {0.0, std::clamp(facing - reach, 0.0, steepest),
            std::clamp(facing + reach, 0.0, steepest), steepest};
}

// dot(wo, wm) has to be above 0, or the cosine of the critical angle. Beyond the critical angle of
// the surface itself, facets that are too flat refract to above it. Those that refract along it,
// normals wo + eta wi with wi.z = 0, have slopes on a circle of radius eta / wo.z about that of the
// facet that faces wo; it touches the cone of the critical angle, and its near side divides the
// facets within the cone.
std::vector<double> refracting_tilts(const glm::dvec3& wo, const glm::dvec2& azimuth, double eta) {
    const auto [along, facing, most] = azimuth_of(wo, azimuth);
    if (eta > 1.0) return {0.0, std::min(facing + 0.5 * pi, 0.5 * pi)};
    if (most <= critical_cosine(eta)) return {};
    const double high = std::min(facing + std::acos(critical_cosine(eta) / most), 0.5 * pi);
    const double beyond = 1.0 - wo.z * wo.z - eta * eta;
    if (beyond <= 0.0) return {0.0, high};
    const double chord = std::sqrt(std::max(along * along - beyond, 0.0));
    return {std::max(std::atan((along - chord) / wo.z), 0.0), high};
}

}  // namespace lacquer::reference
