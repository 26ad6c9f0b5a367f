#include "reference/facets.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "reference/beckmann.h"
#include "reference/ggx.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// a = 1 / (alpha tan theta), with the alpha in the azimuth of w; infinite at normal incidence.
double inverse_scaled_tangent(const Facets& facets, const glm::dvec3& w) {
    return w.z / std::hypot(facets.alpha_x * w.x, facets.alpha_y * w.y);
}

}  // namespace

double slope_density(Ndf ndf, double slope) {
    return ndf == Ndf::ggx ? ggx::slope_density(slope) : beckmann::slope_density(slope);
}

double density(const Facets& facets, const glm::dvec3& wm) {
    const double slope = std::hypot(wm.x / wm.z / facets.alpha_x, wm.y / wm.z / facets.alpha_y);
    const double cos2_theta = wm.z * wm.z / glm::dot(wm, wm);
    return slope_density(facets.ndf, slope) /
           (facets.alpha_x * facets.alpha_y * cos2_theta * cos2_theta);
}

double lambda(const Facets& facets, const glm::dvec3& w) {
    const double a = inverse_scaled_tangent(facets, w);
    return facets.ndf == Ndf::ggx ? ggx::lambda(a) : beckmann::lambda(a);
}

double masking(const Facets& facets, const glm::dvec3& w) {
    return 1.0 / (1.0 + lambda(facets, w));
}

double masking_shadowing(const Facets& facets, const glm::dvec3& wi, const glm::dvec3& wo) {
    return 1.0 / (1.0 + lambda(facets, wi) + lambda(facets, wo));
}

double visible_density(const Facets& facets, const glm::dvec3& w, const glm::dvec3& wm) {
    return masking(facets, w) * std::max(glm::dot(w, wm), 0.0) * density(facets, wm) / w.z;
}

glm::dvec3 sample_visible_normal(const Facets& facets, const glm::dvec3& w, const glm::dvec2& u) {
    // Stretching the surface by 1 / alpha makes both roughnesses 1. A direction stretches with it,
    // a normal the other way.
    const glm::dvec3 stretched =
        glm::normalize(glm::dvec3{facets.alpha_x * w.x, facets.alpha_y * w.y, w.z});
    const glm::dvec3 wm = facets.ndf == Ndf::ggx ? ggx::sample_visible_normal(stretched, u)
                                                 : beckmann::sample_visible_normal(stretched, u);
    return glm::normalize(glm::dvec3{facets.alpha_x * wm.x, facets.alpha_y * wm.y, wm.z});
}

}  // namespace lacquer::reference
