#include "reference/coat.h"

#include <algorithm>
#include <numbers>

#include "reference/equivalent_alpha.h"
#include "reference/fresnel.h"
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

Coat prepare_coat(const Microsurface& microsurface, double eta, const EnergyTables& tables) {
    const double alpha = equivalent_ggx_alpha(microsurface, eta);
    return {{microsurface.ndf, std::max(microsurface.alpha[0], kMinAlpha),
             std::max(microsurface.alpha[1], kMinAlpha)},
            eta,
            alpha,
            tables.t_down_profile(alpha, eta, 1.0),
            tables.fgd_multiple_profile(alpha, eta),
            multiple_scale(tables.fgd_multiple_average(alpha, eta))};
}

double coat_lobe(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo) {
    const double single =
        fresnel(cos_theta_halfway(wi, wo), coat.eta) * reflection_lobe(coat.facets, wi, wo);
    return single + multiple(coat, wi) * multiple(coat, wo) * coat.multiple_scale;
}

double single_share(const Coat& coat, const glm::dvec3& wo) {
    const double all = coat_albedo(coat, wo);
    return all > 0.0 ? std::max(1.0 - multiple(coat, wo) / all, kMinChoice) : 1.0;
}

double coat_pdf(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo) {
    const double single = single_share(coat, wo);
    return single * reflection_pdf(coat.facets, wi, wo) + (1.0 - single) * std::max(wi.z, 0.0) / pi;
}

glm::dvec3 coat_sample(const Coat& coat, const glm::dvec3& wo, double choice, const glm::dvec2& u) {
    return choice < single_share(coat, wo) ? reflection_sample(coat.facets, wo, u)
                                           : sample_cosine(u);
}

double coat_albedo(const Coat& coat, const glm::dvec3& w) {
    return 1.0 - coat.entering.at(w.z);
}

}  // namespace lacquer::reference
