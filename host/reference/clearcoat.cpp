#include "reference/clearcoat.h"

#include <cmath>

#include "reference/reflection.h"

namespace lacquer::reference {

namespace {

// Schlick's approximation; 0 without a coat.
double coat_share(const OneCoat& surface, const glm::dvec3& wo) {
    if (!surface.coat) return 0.0;
    const double eta = surface.coat->eta;
    const double f_zero = std::pow((1.0 - eta) / (1.0 + eta), 2);
    return f_zero + (1.0 - f_zero) * std::pow(1.0 - wo.z, 5);
}

double choice(const ClearcoatSurface& surface, const glm::dvec3& wo) {
    const double share = coat_share(surface, wo);
    return coat_choice(surface, share, (1.0 - share) * mean(base_reflectance(surface, wo.z, 1.0)));
}

}  // namespace

ClearcoatSurface prepare_clearcoat(const Material& material) {
    return {prepare_one_coat(material, Model::clearcoat)};
}

glm::dvec3 eval(const ClearcoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (!is_above(wi) || !is_above(wo)) return glm::dvec3{0.0};
    const double share = coat_share(surface, wo);
    glm::dvec3 f = (1.0 - share) * base_lobe(surface, wi, wo, 1.0);
    if (surface.coat) f += share * reflection_lobe(surface.coat->facets, wi, wo);
    return f;
}

double pdf(const ClearcoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo) {
    return mixture_pdf(surface, choice(surface, wo), wi, wo);
}

Sample sample(const ClearcoatSurface& surface, const glm::dvec3& wo, const glm::dvec3& u) {
    return sample_mixture(surface, choice(surface, wo), wo, u,
                          [&](const glm::dvec3& wi) { return eval(surface, wi, wo); });
}

Albedo albedo(const ClearcoatSurface& surface, const glm::dvec3& wo) {
    Albedo fractions;
    if (!is_above(wo)) return fractions;
    const double share = coat_share(surface, wo);
    if (surface.coat)
        fractions.direct =
            glm::dvec3{share * reflection_integral(surface.coat->facets, wo,
                                                   [](const glm::dvec3&) { return 1.0; })};
    fractions.base = (1.0 - share) * base_albedo(surface, wo);
    return fractions;
}

}  // namespace lacquer::reference
