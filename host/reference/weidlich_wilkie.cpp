#include "reference/weidlich_wilkie.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/fresnel.h"
#include "reference/reflection.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// Refracted directions below the horizon, which only coats of a lower index than the exterior's
// produce, meet the base at grazing incidence.
constexpr double kGrazing = 1e-9;

// Snell's law; 0 beyond the critical angle.
double refracted_cosine(const CoatLayer& coat, double cos_theta) {
    const double sin2_theta_t = (1.0 - cos_theta * cos_theta) / (coat.eta * coat.eta);
    return std::sqrt(std::max(1.0 - sin2_theta_t, 0.0));
}

// T12 a t, with t = (1 - G) + T21 G: light of one angle to a facet passes it twice.
glm::dvec3 passage(const CoatLayer& coat, double cos_theta, double masking_shadowing) {
    const double transmittance = 1.0 - fresnel(cos_theta, coat.eta);
    const double cos_theta_t = refracted_cosine(coat, cos_theta);
    if (transmittance <= 0.0 || cos_theta_t <= 0.0) return glm::dvec3{0.0};
    const glm::dvec3 absorption = glm::pow(coat.tau, glm::dvec3{2.0 / cos_theta_t});
    return transmittance * absorption *
           (1.0 - masking_shadowing + transmittance * masking_shadowing);
}

// `w` as it travels below the facet wm, still pointing away from the base.
glm::dvec3 refract(const CoatLayer& coat, const glm::dvec3& w, const glm::dvec3& wm,
                   double cos_theta) {
    const glm::dvec3 along_facet = (w - cos_theta * wm) / coat.eta;
    glm::dvec3 refracted = along_facet + refracted_cosine(coat, cos_theta) * wm;
    refracted.z = std::max(refracted.z, kGrazing);
    return refracted;
}

// The base's f between the refracted directions.
glm::dvec3 refracted_base_lobe(const WeidlichWilkieSurface& surface, const glm::dvec3& wi,
                               const glm::dvec3& wo) {
    const CoatLayer& coat = *surface.coat;
    const glm::dvec3 wm = halfway(wi, wo);
    const double cos_theta = cos_theta_halfway(wi, wo);
    const glm::dvec3 reflectance =
        base_reflectance(surface, refracted_cosine(coat, cos_theta), coat.eta);
    if (!surface.conductor) return reflectance / pi;
    const glm::dvec3 wi_below = refract(coat, wi, wm, cos_theta);
    const glm::dvec3 wo_below = refract(coat, wo, wm, cos_theta);
    const Facets& facets = surface.conductor->facets;
    return reflectance * density(facets, wm) * masking_shadowing(facets, wi_below, wo_below) /
           (4.0 * wi_below.z * wo_below.z);
}

glm::dvec3 coated_base_lobe(const WeidlichWilkieSurface& surface, const glm::dvec3& wi,
                            const glm::dvec3& wo) {
    if (!surface.coat) return base_lobe(surface, wi, wo, 1.0);
    const double both_see = masking_shadowing(surface.coat->facets, wi, wo);
    return passage(*surface.coat, cos_theta_halfway(wi, wo), both_see) *
           refracted_base_lobe(surface, wi, wo);
}

double choice(const WeidlichWilkieSurface& surface, const glm::dvec3& wo) {
    if (!surface.coat) return 0.0;
    const glm::dvec3 base =
        base_reflectance(surface, refracted_cosine(*surface.coat, wo.z), surface.coat->eta) *
        passage(*surface.coat, wo.z, 1.0);
    return coat_choice(surface, fresnel(wo.z, surface.coat->eta), mean(base));
}

}  // namespace

WeidlichWilkieSurface prepare_weidlich_wilkie(const Material& material) {
    return {prepare_one_coat(material, Model::weidlich_wilkie)};
}

glm::dvec3 eval(const WeidlichWilkieSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return glm::dvec3{0.0};
    return coat_lobe(surface, wi, wo) + coated_base_lobe(surface, wi, wo);
}

double pdf(const WeidlichWilkieSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    return mixture_pdf(surface, choice(surface, wo), wi, wo);
}

Sample sample(const WeidlichWilkieSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    return sample_mixture(surface, choice(surface, wo), wo, u,
                          [&](const glm::dvec3& wi) { return eval(surface, wi, wo); });
}

Albedo albedo(const WeidlichWilkieSurface& surface, const glm::dvec3& wo) {
    if (!is_above(wo)) return {};
    Albedo fractions{glm::dvec3{coat_albedo(surface, wo)}, {}};
    if (!surface.coat) {
        fractions.base = base_albedo(surface, wo);
        return fractions;
    }
    for (int c = 0; c < 3; ++c) {
        if (surface.albedo)
            fractions.base[c] = pi * cosine_integral(wo, [&](const glm::dvec3& wi) {
                                    return coated_base_lobe(surface, wi, wo)[c];
                                });
        if (surface.conductor) {
            const Facets& facets = surface.conductor->facets;
            fractions.base[c] = reflection_integral(facets, wo, [&](const glm::dvec3& wi) {
                const double lobe = reflection_lobe(facets, wi, wo);
                return lobe > 0.0 ? coated_base_lobe(surface, wi, wo)[c] / lobe : 0.0;
            });
        }
    }
    return fractions;
}

}  // namespace lacquer::reference
