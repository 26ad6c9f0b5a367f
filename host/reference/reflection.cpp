#include "reference/reflection.h"

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/fresnel.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;
using Quadrature = boost::math::quadrature::gauss_kronrod<double, 21>;

// The inner integral is a step finer than the outer one, which would take its error for structure.
constexpr double kOuterTolerance = 1e-8;
constexpr double kInnerTolerance = 1e-9;
constexpr unsigned kMaxHalvings = 12;

// A ray of slopes from slope 0, along which facets grow steeper until they mirror wo below the
// horizon.
struct SlopeRay {
    glm::dvec2 direction;  // alpha (cos psi, sin psi): slope per unit of steepness
    double steepest;       // in units of alpha; infinite at grazing incidence only
};

// A facet of slope (p, q) mirrors wo to the horizon where
//     p^2 + q^2 + 2 (p wo.x + q wo.y) / wo.z = 1,
// a circle around the origin: a quadratic in the distance along the ray.
SlopeRay slope_ray(const Facets& facets, const glm::dvec3& wo, double psi) {
    const glm::dvec2 d{facets.alpha_x * std::cos(psi), facets.alpha_y * std::sin(psi)};
    const double length_squared = glm::dot(d, d);
    const double along = glm::dot(d, glm::dvec2{wo.x, wo.y} / wo.z);
    const double root = std::hypot(along, std::sqrt(length_squared));
    // Both are the positive root; each is free of cancellation for its sign of `along`.
    const double steepest = along > 0.0 ? 1.0 / (along + root) : (root - along) / length_squared;
    return {d, steepest};
}

}  // namespace

glm::dvec3 halfway(const glm::dvec3& wi, const glm::dvec3& wo) {
    return glm::normalize(wi + wo);
}

double cos_theta_halfway(const glm::dvec3& wi, const glm::dvec3& wo) {
    const glm::dvec3 wm = halfway(wi, wo);
    return 0.5 * (glm::dot(wi, wm) + glm::dot(wo, wm));
}

double reflection_lobe(const Facets& facets, const glm::dvec3& wi, const glm::dvec3& wo) {
    return density(facets, halfway(wi, wo)) * masking_shadowing(facets, wi, wo) /
           (4.0 * wi.z * wo.z);
}

double reflection_pdf(const Facets& facets, const glm::dvec3& wi, const glm::dvec3& wo) {
    // D_wo(wm) / (4 dot(wo, wm)), where the dot product cancels; computed, it is negative for some
    // nearly opposite directions that are unit only to the precision of a float.
    return masking(facets, wo) * density(facets, halfway(wi, wo)) / (4.0 * wo.z);
}

glm::dvec3 reflection_sample(const Facets& facets, const glm::dvec3& wo, const glm::dvec2& u) {
    const glm::dvec3 wm = sample_visible_normal(facets, wo, u);
    return 2.0 * glm::dot(wo, wm) * wm - wo;
}

// Over facet slopes instead of wi (d wi = 4 dot(wo, wm) d wm, and D d wm = density of slopes /
// wm.z), in polar coordinates whose radius is tan(x) in units of alpha: the integrand is then
// smooth at every roughness, and the horizon of wi is the end of the inner interval.
double reflection_integral(const Facets& facets, const glm::dvec3& wo, const Factor& factor) {
    const auto along_ray = [&](double psi) {
        const SlopeRay ray = slope_ray(facets, wo, psi);
        const auto integrand = [&](double x) {
            const double steepness = std::tan(x);
            const glm::dvec2 slope = steepness * ray.direction;
            const glm::dvec3 wm = glm::normalize(glm::dvec3{-slope.x, -slope.y, 1.0});
            const double cos_theta = glm::dot(wo, wm);
            const glm::dvec3 wi = 2.0 * cos_theta * wm - wo;
            if (wi.z <= 0.0) return 0.0;  // rounding at the end of the interval
            return slope_density(facets.ndf, steepness) * steepness *
                   (1.0 + steepness * steepness) * factor(wi) * masking_shadowing(facets, wi, wo) *
                   cos_theta / (wm.z * wo.z);
        };
        return Quadrature::integrate(integrand, 0.0, std::atan(ray.steepest), kMaxHalvings,
                                     kInnerTolerance);
    };
    // From the azimuth of wo, so that symmetric halves split at a node.
    const double start = std::atan2(facets.alpha_y * wo.y, facets.alpha_x * wo.x);
    return Quadrature::integrate(along_ray, start, start + 2.0 * pi, kMaxHalvings, kOuterTolerance);
}

double cosine_integral(const glm::dvec3& wo, const Factor& factor) {
    const double start = std::atan2(wo.y, wo.x);
    const auto around = [&](double z) {
        const double radius = std::sqrt((1.0 - z) * (1.0 + z));
        const auto integrand = [&](double phi) {
            return factor({radius * std::cos(phi), radius * std::sin(phi), z});
        };
        return z / pi *
               Quadrature::integrate(integrand, start, start + 2.0 * pi, kMaxHalvings,
                                     kInnerTolerance);
    };
    return Quadrature::integrate(around, 0.0, 1.0, kMaxHalvings, kOuterTolerance);
}

double reflection_albedo(const Facets& facets, std::complex<double> eta, const glm::dvec3& wo) {
    return reflection_integral(
        facets, wo, [&](const glm::dvec3& wi) { return fresnel(cos_theta_halfway(wi, wo), eta); });
}

}  // namespace lacquer::reference
