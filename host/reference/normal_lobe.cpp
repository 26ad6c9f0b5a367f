#include "reference/normal_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "reference/reflection.h"
#include "reference/shading.h"

namespace lacquer::reference {

namespace {

constexpr glm::dvec3 kNormal{0.0, 0.0, 1.0};

// Of x^2 + y^2 <= 1, half per axis. Compression can take the variance of next to no light beyond.
constexpr double kMaxVariance = 0.5;

// Facets steeper than 45 degrees mirror the normal below the horizon. Of the facets as seen along
// the normal, the fraction of slope below s is s^2 / (alpha^2 + s^2).
double share_above(double alpha) {
    return 1.0 / (1.0 + alpha * alpha);
}

}  // namespace

NormalLobe prepare_normal_lobe(double variance, const EnergyTables& tables) {
    const double alpha =
        std::max(tables.equivalent_alpha(std::clamp(variance, 0.0, kMaxVariance)), kMinAlpha);
    return {{Ndf::ggx, alpha, alpha}, tables.mirror_single(1.0, alpha)};
}

double normal_lobe(const NormalLobe& lobe, const glm::dvec3& wi) {
    return reflection_lobe(lobe.facets, wi, kNormal) / lobe.energy;
}

double normal_lobe_pdf(const NormalLobe& lobe, const glm::dvec3& wi) {
    return density(lobe.facets, halfway(wi, kNormal)) / (4.0 * share_above(lobe.facets.alpha_x));
}

glm::dvec3 normal_lobe_sample(const NormalLobe& lobe, const glm::dvec2& u) {
    const double alpha = lobe.facets.alpha_x;
    const double share = u.x * share_above(alpha);
    const double tan2_theta_m = alpha * alpha * share / (1.0 - share);
    const double cos2_theta_m = 1.0 / (1.0 + tan2_theta_m);
    // The mirrored normal is twice as far from the normal as the facet's.
    const double cos_theta = 2.0 * cos2_theta_m - 1.0;
    const double sin_theta = 2.0 * cos2_theta_m * std::sqrt(tan2_theta_m);
    const double phi = 2.0 * std::numbers::pi * u.y;
    return {sin_theta * std::cos(phi), sin_theta * std::sin(phi), std::max(cos_theta, 0.0)};
}

}  // namespace lacquer::reference
