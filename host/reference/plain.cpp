#include "reference/plain.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string_view>

#include "core/error.h"
#include "reference/fresnel.h"
#include "reference/reflection.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

void refuse_blend(const Material& material, const Roughness& roughness, std::string_view pointer) {
    if (std::holds_alternative<Blend>(roughness))
        throw Error{fmt::format(
            "material '{}': {}/blend: the model 'plain' cannot shade a blended microsurface",
            material.name, pointer)};
}

Facets facets_of(const Material& material, const Roughness& roughness, std::string_view pointer) {
    refuse_blend(material, roughness, pointer);
    const Microsurface& microsurface = std::get<Microsurface>(roughness);
    return {microsurface.ndf, std::max(microsurface.alpha[0], kMinAlpha),
            std::max(microsurface.alpha[1], kMinAlpha)};
}

void prepare_base(const Material& material, PlainSurface& surface) {
    if (const auto* lambertian = std::get_if<LambertianBase>(&material.base))
        surface.albedo = vector_of(lambertian->albedo);
    if (const auto* diffuse = std::get_if<DiffuseFacetsBase>(&material.base)) {
        refuse_blend(material, diffuse->roughness, "/base/diffuse_facets");
        surface.albedo = vector_of(diffuse->albedo);
    }
    if (const auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        surface.conductor =
            PlainConductor{facets_of(material, conductor->roughness, "/base/conductor"), {}};
        for (std::size_t i = 0; i < 3; ++i)
            surface.conductor->eta[i] =
                std::complex{conductor->eta[i], conductor->kappa[i]} / material.exterior_ior;
    }
}

glm::dvec3 fresnel_rgb(const PlainConductor& conductor, double cos_theta) {
    return {fresnel(cos_theta, conductor.eta[0]), fresnel(cos_theta, conductor.eta[1]),
            fresnel(cos_theta, conductor.eta[2])};
}

// Less than this is the rounding of Fresnel's formulas where the exact value is 0.
constexpr double kNoReflectance = 1e-20;

// The probability of choosing the coat for a viewer at wo.
double coat_choice(const PlainSurface& surface, const glm::dvec3& wo) {
    if (!surface.coat) return 0.0;
    if (!surface.albedo && !surface.conductor) return 1.0;
    const double coat = fresnel(wo.z, surface.coat->eta);
    const double base =
        surface.albedo ? mean(*surface.albedo) : mean(fresnel_rgb(*surface.conductor, wo.z));
    if (coat + base < kNoReflectance) return kMinChoice;
    return std::clamp(coat / (coat + base), kMinChoice, 1.0 - kMinChoice);
}

glm::dvec3 sample_direction(const PlainSurface& surface, const glm::dvec3& wo,
                            const glm::dvec3& u) {
    const glm::dvec2 point{u.y, u.z};
    if (u.x < coat_choice(surface, wo)) return reflection_sample(surface.coat->facets, wo, point);
    if (surface.conductor) return reflection_sample(surface.conductor->facets, wo, point);
    return sample_cosine(point);
}

}  // namespace

PlainSurface prepare_plain(const Material& material) {
    PlainSurface surface;
    if (!material.layers.empty()) {
        const Interface& top = material.layers.front().interface;
        surface.coat = PlainCoat{facets_of(material, top.roughness, "/layers/0/interface"),
                                 top.ior / material.exterior_ior};
    }
    prepare_base(material, surface);
    return surface;
}

glm::dvec3 eval(const PlainSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return glm::dvec3{0.0};
    glm::dvec3 f{0.0};
    if (surface.coat)
        f += fresnel(cos_theta_halfway(wi, wo), surface.coat->eta) *
             reflection_lobe(surface.coat->facets, wi, wo);
    if (surface.albedo) f += *surface.albedo / pi;
    if (surface.conductor)
        f += fresnel_rgb(*surface.conductor, cos_theta_halfway(wi, wo)) *
             reflection_lobe(surface.conductor->facets, wi, wo);
    return f;
}

double pdf(const PlainSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return 0.0;
    const double coat = coat_choice(surface, wo);
    double density = 0.0;
    if (surface.coat) density += coat * reflection_pdf(surface.coat->facets, wi, wo);
    if (surface.albedo) density += (1.0 - coat) * wi.z / pi;
    if (surface.conductor)
        density += (1.0 - coat) * reflection_pdf(surface.conductor->facets, wi, wo);
    return density;
}

Sample sample(const PlainSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    Sample chosen;
    if (!is_above(wo)) return chosen;
    chosen.wi = sample_direction(surface, wo, u);
    chosen.pdf = pdf(surface, chosen.wi, wo);
    if (chosen.pdf > 0.0) chosen.weight = eval(surface, chosen.wi, wo) * chosen.wi.z / chosen.pdf;
    return chosen;
}

Albedo albedo(const PlainSurface& surface, const glm::dvec3& wo) {
    Albedo fractions;
    if (!is_above(wo)) return fractions;
    if (surface.coat)
        fractions.direct =
            glm::dvec3{reflection_albedo(surface.coat->facets, surface.coat->eta, wo)};
    if (surface.albedo) fractions.base = *surface.albedo;
    if (surface.conductor)
        for (int i = 0; i < 3; ++i)
            fractions.base[i] =
                reflection_albedo(surface.conductor->facets, surface.conductor->eta[i], wo);
    return fractions;
}

}  // namespace lacquer::reference
