#include "simulator/facet_material.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::simulator {

namespace {

Vec3 mirror(const Vec3& direction, const Vec3& wm) {
    return direction - 2.0 * glm::dot(direction, wm) * wm;
}

FacetEvent meet_dielectric(const DielectricFacet& facet, const Vec3& direction, const Vec3& wm,
                           RandomStream& random) {
    const double cos_i = std::min(-glm::dot(direction, wm), 1.0);
    if (random.uniform() < dielectric_reflectance(cos_i, facet.eta))
        return {mirror(direction, wm), Vec3{1.0}, false};
    const double cos_t =
        std::sqrt(std::max(0.0, 1.0 - (1.0 - cos_i * cos_i) / (facet.eta * facet.eta)));
    const Vec3 refracted = direction / facet.eta + wm * (cos_i / facet.eta - cos_t);
    return {glm::normalize(refracted), Vec3{1.0}, true};
}

FacetEvent meet_conductor(const ConductorFacet& facet, const Vec3& direction, const Vec3& wm) {
    const double cos_i = std::min(-glm::dot(direction, wm), 1.0);
    Vec3 weight{};
    for (int channel = 0; channel < 3; ++channel) {
        const auto index = static_cast<std::size_t>(channel);
        weight[channel] = conductor_reflectance(cos_i, facet.eta[index], facet.kappa[index]);
    }
    return {mirror(direction, wm), weight, false};
}

FacetEvent meet_diffuse(const DiffuseFacet& facet, const Vec3& wm, RandomStream& random) {
    // A point of the unit sphere about the tip of the normal is cosine-distributed about it.
    const double z = 2.0 * random.uniform() - 1.0;
    const double phi = 2.0 * std::numbers::pi * random.uniform();
    const double radius = std::sqrt(1.0 - z * z);
    const Vec3 sum = wm + Vec3{radius * std::cos(phi), radius * std::sin(phi), z};
    return {glm::normalize(sum), Vec3{facet.albedo[0], facet.albedo[1], facet.albedo[2]}, false};
}

}  // namespace

double dielectric_reflectance(double cos_theta_i, double eta) {
    const double sin2_theta_t = (1.0 - cos_theta_i * cos_theta_i) / (eta * eta);
    if (sin2_theta_t >= 1.0) return 1.0;
    const double cos_theta_t = std::sqrt(1.0 - sin2_theta_t);
    const double s = (cos_theta_i - eta * cos_theta_t) / (cos_theta_i + eta * cos_theta_t);
    const double p = (eta * cos_theta_i - cos_theta_t) / (eta * cos_theta_i + cos_theta_t);
    return 0.5 * (s * s + p * p);
}

double conductor_reflectance(double cos_theta_i, double eta, double kappa) {
    using Complex = std::complex<double>;
    const Complex index{eta, kappa};
    if (index == Complex{}) return 1.0;
    const Complex sin_theta_t = std::sqrt(1.0 - cos_theta_i * cos_theta_i) / index;
    const Complex cos_theta_t = std::sqrt(1.0 - sin_theta_t * sin_theta_t);
    const Complex s = (cos_theta_i - index * cos_theta_t) / (cos_theta_i + index * cos_theta_t);
    const Complex p = (index * cos_theta_i - cos_theta_t) / (index * cos_theta_i + cos_theta_t);
    return 0.5 * (std::norm(s) + std::norm(p));
}

FacetEvent meet_facet(const FacetMaterial& material, const Vec3& direction, const Vec3& wm,
                      RandomStream& random) {
    if (const auto* dielectric = std::get_if<DielectricFacet>(&material))
        return meet_dielectric(*dielectric, direction, wm, random);
    if (const auto* conductor = std::get_if<ConductorFacet>(&material))
        return meet_conductor(*conductor, direction, wm);
    return meet_diffuse(std::get<DiffuseFacet>(material), wm, random);
}

}  // namespace lacquer::simulator
