#include "reference/coat.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/blended_energies.h"
#include "reference/equivalent_alpha.h"
#include "reference/microsurface/rough_surface.h"
#include "reference/microsurface/visible_normals.h"
#include "reference/reflection.h"
#include "reference/shading.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// Of an average of m: 1 / (pi average), and in proportion to it below the least.
double multiple_scale(double average) {
    const double bounded = std::max(average, kLeastMultipleAverage);
    return average / (pi * bounded * bounded);
}

double multiple(const Coat& coat, const glm::dvec3& w) {
    return std::clamp(coat.multiple.at(w.z), 0.0, 1.0);
}

}  // namespace

Coat prepare_coat(const Roughness& roughness, double eta, const EnergyTables& tables) {
    const Blend blend = strata_of(roughness);
    std::vector<double> alphas;
    std::vector<DirectionPolynomial> entering, multiple;
    double average = 0.0;
    for (const Stratum& stratum : blend.strata) {
        const double alpha = equivalent_ggx_alpha(stratum.microsurface, eta);
        alphas.push_back(alpha);
        entering.push_back(tables.t_down_profile(alpha, eta, 1.0).polynomial());
        multiple.push_back(tables.fgd_multiple_profile(alpha, eta));
        average = tables.fgd_multiple_average(alpha, eta);
    }
    const FacetStrata facets = isotropic_strata(blend, alphas);
    const DirectionPolynomial several = blended(facets, multiple);
    if (multiple.size() > 1) average = std::max(2.0 * several.energy(), 0.0);
    return {dielectric_side({eta, roughness}, 1.0), eta,
            TransmissionProfile{blended(facets, entering)}, several, multiple_scale(average)};
}

double coat_lobe(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo) {
    return reflected_once(coat.side, wi, wo).x +
           multiple(coat, wi) * multiple(coat, wo) * coat.multiple_scale;
}

double coat_mirrored_pdf(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo) {
    // The visible density / (4 dot(wo, wm)).
    const glm::dvec3 wm = halfway(wi, wo);
    const double cosine = glm::dot(wo, wm);
    return cosine > 0.0 ? visible_density(coat.side.facets, wo, wm) / (4.0 * cosine) : 0.0;
}

glm::dvec3 coat_mirrored(const Coat& coat, const glm::dvec3& wo, const glm::dvec3& u) {
    const glm::dvec3 wm = sample_visible_normal(coat.side.facets, wo, u).wm;
    return 2.0 * glm::dot(wo, wm) * wm - wo;
}

double single_share(const Coat& coat, const glm::dvec3& wo) {
    const double all = coat_albedo(coat, wo);
    return all > 0.0 ? std::max(1.0 - multiple(coat, wo) / all, kMinChoice) : 1.0;
}

double coat_pdf(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo) {
    const double single = single_share(coat, wo);
    return single * coat_mirrored_pdf(coat, wi, wo) + (1.0 - single) * std::max(wi.z, 0.0) / pi;
}

glm::dvec3 coat_sample(const Coat& coat, const glm::dvec3& wo, double choice, const glm::dvec2& u) {
    const double single = single_share(coat, wo);
    return choice < single ? coat_mirrored(coat, wo, {choice / single, u}) : sample_cosine(u);
}

double coat_albedo(const Coat& coat, const glm::dvec3& w) {
    return 1.0 - coat.entering.at(w.z);
}

}  // namespace lacquer::reference
