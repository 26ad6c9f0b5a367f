#include "reference/microsurface/refraction.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace lacquer::reference {

std::optional<glm::dvec3> refraction_halfway(const glm::dvec3& wi, const glm::dvec3& wo,
                                             double eta) {
    const glm::dvec3 sum = wo + eta * wi;
    const glm::dvec3 wm = glm::normalize(sum.z < 0.0 ? -sum : sum);
    if (!(glm::dot(wo, wm) > 0.0 && glm::dot(wi, wm) < 0.0)) return std::nullopt;
    return wm;
}

std::optional<glm::dvec3> refracted(const glm::dvec3& wo, const glm::dvec3& wm, double eta) {
    const double cos_theta = glm::dot(wo, wm);
    const double cos2_theta_t = 1.0 - (1.0 - cos_theta * cos_theta) / (eta * eta);
    if (cos2_theta_t <= 0.0) return std::nullopt;
    return glm::normalize((cos_theta / eta - std::sqrt(cos2_theta_t)) * wm - wo / eta);
}

double refraction_jacobian(const glm::dvec3& wi, const glm::dvec3& wo, const glm::dvec3& wm,
                           double eta) {
    const double both = glm::dot(wo, wm) + eta * glm::dot(wi, wm);
    return eta * eta * std::abs(glm::dot(wi, wm)) / (both * both);
}

}  // namespace lacquer::reference
