#include "reference/plain.h"

#include "reference/fresnel.h"

namespace lacquer::reference {

namespace {

double choice(const PlainSurface& surface, const glm::dvec3& wo) {
    const double coat = surface.coat ? fresnel(wo.z, surface.coat->eta) : 0.0;
    return coat_choice(surface, coat, mean(base_reflectance(surface, wo.z, 1.0)));
}

}  // namespace

PlainSurface prepare_plain(const Material& material) {
    return {prepare_one_coat(material, Model::plain)};
}

glm::dvec3 eval(const PlainSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return glm::dvec3{0.0};
    return coat_lobe(surface, wi, wo) + base_lobe(surface, wi, wo, 1.0);
}

double pdf(const PlainSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    return mixture_pdf(surface, choice(surface, wo), wi, wo);
}

Sample sample(const PlainSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    return sample_mixture(surface, choice(surface, wo), wo, u,
                          [&](const glm::dvec3& wi) { return eval(surface, wi, wo); });
}

Albedo albedo(const PlainSurface& surface, const glm::dvec3& wo) {
    if (!is_above(wo)) return {};
    return {glm::dvec3{coat_albedo(surface, wo)}, base_albedo(surface, wo)};
}

}  // namespace lacquer::reference
