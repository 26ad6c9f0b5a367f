#include "reference/openpbr_coat.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>

#include "reference/fresnel.h"

namespace lacquer::reference {

namespace {

// In units of the coat's thickness.
constexpr double kLongestPath = 30.0;

// E_F, the average Fresnel reflectance: d'Eon's fit, which the specification recommends.
double average_fresnel(double eta) {
    if (eta < 1.0) return 1.0 - eta * eta * (1.0 - average_fresnel(1.0 / eta));
    return std::log((10893.0 * eta - 1438.2) / (-774.4 * eta * eta + 10212.0 * eta + 1.0));
}

double variance(const Facets& facets) {
    return 0.5 * (facets.alpha_x * facets.alpha_x + facets.alpha_y * facets.alpha_y);
}

// r' = min(1, r_base^4 + 2 r_coat^4)^(1/4), the fourth power of a roughness being a variance; both
// alphas are squares of roughnesses and keep their ratio.
Facets roughened(const Facets& base, const Facets& coat) {
    const double alpha = std::sqrt(variance(base));
    const double scale = std::sqrt(std::min(1.0, variance(base) + 2.0 * variance(coat))) / alpha;
    return {base.ndf, std::min(scale * base.alpha_x, 1.0), std::min(scale * base.alpha_y, 1.0)};
}

double path_length(const CoatLayer& coat, double cos_theta) {
    const double sin2_theta_t = (1.0 - cos_theta * cos_theta) / (coat.eta * coat.eta);
    return 1.0 / std::max(std::sqrt(std::max(1.0 - sin2_theta_t, 0.0)), 1.0 / kLongestPath);
}

// T_coat to the power of both paths, per channel.
glm::dvec3 absorption(const CoatLayer& coat, const glm::dvec3& wi, const glm::dvec3& wo) {
    return glm::pow(coat.tau, glm::dvec3{path_length(coat, wi.z) + path_length(coat, wo.z)});
}

// (1 - E_coat) Delta, the specification's equation for the darkening factor Delta.
glm::dvec3 attenuation(const OpenpbrCoatSurface& surface, const glm::dvec3& wo) {
    const double reflected = fresnel(wo.z, surface.coat->eta);
    if (reflected >= 1.0) return glm::dvec3{0.0};
    const double k = glm::mix(reflected, surface.diffuse_reflectance, surface.base_roughness);
    return (1.0 - reflected) * (1.0 - k) / (1.0 - k * surface.base_albedo);
}

glm::dvec3 coated_base_lobe(const OpenpbrCoatSurface& surface, const glm::dvec3& wi,
                            const glm::dvec3& wo) {
    const glm::dvec3 lobe = base_lobe(surface, wi, wo, eta_above_base(surface));
    if (!surface.coat) return lobe;
    return lobe * attenuation(surface, wo) * absorption(*surface.coat, wi, wo);
}

double choice(const OpenpbrCoatSurface& surface, const glm::dvec3& wo) {
    if (!surface.coat) return 0.0;
    const glm::dvec3 normal{0.0, 0.0, 1.0};
    const glm::dvec3 base =
        surface.base_albedo * attenuation(surface, wo) * absorption(*surface.coat, normal, wo);
    return coat_choice(surface, fresnel(wo.z, surface.coat->eta), mean(base));
}

}  // namespace

OpenpbrCoatSurface prepare_openpbr_coat(const Material& material) {
    OpenpbrCoatSurface surface{prepare_one_coat(material, Model::openpbr_coat)};
    if (!surface.coat) return surface;
    const double eta = surface.coat->eta;
    surface.base_albedo = base_reflectance(surface, 1.0, eta);
    surface.diffuse_reflectance = 1.0 - (1.0 - average_fresnel(eta)) / (eta * eta);
    if (surface.conductor) {
        surface.base_roughness = std::pow(variance(surface.conductor->facets), 0.25);
        surface.conductor->facets = roughened(surface.conductor->facets, surface.coat->facets);
    }
    return surface;
}

glm::dvec3 eval(const OpenpbrCoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return glm::dvec3{0.0};
    return coat_lobe(surface, wi, wo) + coated_base_lobe(surface, wi, wo);
}

double pdf(const OpenpbrCoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    return mixture_pdf(surface, choice(surface, wo), wi, wo);
}

Sample sample(const OpenpbrCoatSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    return sample_mixture(surface, choice(surface, wo), wo, u,
                          [&](const glm::dvec3& wi) { return eval(surface, wi, wo); });
}

Albedo albedo(const OpenpbrCoatSurface& surface, const glm::dvec3& wo) {
    if (!is_above(wo)) return {};
    Albedo fractions{glm::dvec3{coat_albedo(surface, wo)}, base_albedo(surface, wo)};
    if (surface.coat)
        fractions.base = attenuation(surface, wo) *
                         base_integral(surface, wo, surface.coat->eta, [&](const glm::dvec3& wi) {
                             return absorption(*surface.coat, wi, wo);
                         });
    return fractions;
}

}  // namespace lacquer::reference
