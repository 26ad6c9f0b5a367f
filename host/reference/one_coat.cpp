#include "reference/one_coat.h"

#include <algorithm>
#include <cmath>
#include <glm/exponential.hpp>
#include <numbers>

#include "core/model_scope.h"
#include "reference/fresnel.h"
#include "reference/reflection.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// Less than this is the rounding of Fresnel's formulas where the exact value is 0.
constexpr double kNoReflectance = 1e-20;

Facets facets_of(const Roughness& roughness) {
    const Microsurface& microsurface = std::get<Microsurface>(roughness);
    return {microsurface.ndf, std::max(microsurface.alpha[0], kMinAlpha),
            std::max(microsurface.alpha[1], kMinAlpha)};
}

glm::dvec3 transmittance_of(const Medium& medium) {
    if (const auto* absorbing = std::get_if<AbsorbingMedium>(&medium))
        return vector_of(absorbing->tau);
    const ScatteringMedium& scattering = std::get<ScatteringMedium>(medium);
    return glm::exp(-scattering.thickness * vector_of(scattering.sigma_a));
}

Conductor conductor_of(const ConductorBase& base, double exterior_ior) {
    Conductor conductor{facets_of(base.roughness), {}};
    for (std::size_t i = 0; i < 3; ++i)
        conductor.eta[i] = std::complex{base.eta[i], base.kappa[i]} / exterior_ior;
    return conductor;
}

}  // namespace

OneCoat prepare_one_coat(const Material& material, Model model) {
    require_shadeable(material, model);
    OneCoat surface;
    if (!material.layers.empty()) {
        const Layer& top = material.layers.front();
        surface.coat =
            CoatLayer{facets_of(top.interface.roughness), top.interface.ior / material.exterior_ior,
                      transmittance_of(top.medium)};
    }
    if (const auto* lambertian = std::get_if<LambertianBase>(&material.base))
        surface.albedo = vector_of(lambertian->albedo);
    if (const auto* diffuse = std::get_if<DiffuseFacetsBase>(&material.base))
        surface.albedo = vector_of(diffuse->albedo);
    if (const auto* conductor = std::get_if<ConductorBase>(&material.base))
        surface.conductor = conductor_of(*conductor, material.exterior_ior);
    return surface;
}

double eta_above_base(const OneCoat& surface) {
    return surface.coat ? surface.coat->eta : 1.0;
}

double coat_lobe(const OneCoat& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!surface.coat) return 0.0;
    return fresnel(cos_theta_halfway(wi, wo), surface.coat->eta) *
           reflection_lobe(surface.coat->facets, wi, wo);
}

double coat_albedo(const OneCoat& surface, const glm::dvec3& wo) {
    return surface.coat ? reflection_albedo(surface.coat->facets, surface.coat->eta, wo) : 0.0;
}

glm::dvec3 base_reflectance(const OneCoat& surface, double cos_theta, double eta_above) {
    if (surface.albedo) return *surface.albedo;
    if (!surface.conductor) return glm::dvec3{0.0};
    const auto& eta = surface.conductor->eta;
    return {fresnel(cos_theta, eta[0] / eta_above), fresnel(cos_theta, eta[1] / eta_above),
            fresnel(cos_theta, eta[2] / eta_above)};
}

glm::dvec3 base_lobe(const OneCoat& surface, const glm::dvec3& wi, const glm::dvec3& wo,
                     double eta_above) {
    const glm::dvec3 reflectance = base_reflectance(surface, cos_theta_halfway(wi, wo), eta_above);
    if (!surface.conductor) return reflectance / pi;
    return reflectance * reflection_lobe(surface.conductor->facets, wi, wo);
}

glm::dvec3 base_integral(const OneCoat& surface, const glm::dvec3& wo, double eta_above,
                         const RgbFactor& factor) {
    glm::dvec3 integral{0.0};
    for (int c = 0; c < 3; ++c) {
        if (surface.albedo)
            integral[c] = (*surface.albedo)[c] *
                          cosine_integral(wo, [&](const glm::dvec3& wi) { return factor(wi)[c]; });
        if (surface.conductor)
            integral[c] =
                reflection_integral(surface.conductor->facets, wo, [&](const glm::dvec3& wi) {
                    const double cos_theta = cos_theta_halfway(wi, wo);
                    return base_reflectance(surface, cos_theta, eta_above)[c] * factor(wi)[c];
                });
    }
    return integral;
}

glm::dvec3 base_albedo(const OneCoat& surface, const glm::dvec3& wo) {
    if (surface.albedo) return *surface.albedo;
    return base_integral(surface, wo, 1.0, [](const glm::dvec3&) { return glm::dvec3{1.0}; });
}

double coat_choice(const OneCoat& surface, double coat, double base) {
    if (!surface.coat) return 0.0;
    if (!surface.albedo && !surface.conductor) return 1.0;
    if (coat + base < kNoReflectance) return kMinChoice;
    return std::clamp(coat / (coat + base), kMinChoice, 1.0 - kMinChoice);
}

double mixture_pdf(const OneCoat& surface, double coat_choice, const glm::dvec3& wi,
                   const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return 0.0;
    double density = 0.0;
    if (surface.coat) density += coat_choice * reflection_pdf(surface.coat->facets, wi, wo);
    if (surface.albedo) density += (1.0 - coat_choice) * wi.z / pi;
    if (surface.conductor)
        density += (1.0 - coat_choice) * reflection_pdf(surface.conductor->facets, wi, wo);
    return density;
}

Sample sample_mixture(const OneCoat& surface, double coat_choice, const glm::dvec3& wo,
                      const glm::dvec3& u,
                      const std::function<glm::dvec3(const glm::dvec3& wi)>& eval) {
    Sample chosen;
    if (!is_above(wo)) return chosen;
    const glm::dvec2 point{u.y, u.z};
    if (u.x < coat_choice)
        chosen.wi = reflection_sample(surface.coat->facets, wo, point);
    else if (surface.conductor)
        chosen.wi = reflection_sample(surface.conductor->facets, wo, point);
    else
        chosen.wi = sample_cosine(point);
    chosen.pdf = mixture_pdf(surface, coat_choice, chosen.wi, wo);
    if (chosen.pdf > 0.0) chosen.weight = eval(chosen.wi) * chosen.wi.z / chosen.pdf;
    return chosen;
}

}  // namespace lacquer::reference
