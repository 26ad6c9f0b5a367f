#include "simulator/facet_material.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <glm/geometric.hpp>

namespace lacquer::simulator {

namespace {

Vec3 mirror(const Vec3& direction, const Vec3& wm) {
    return direction - 2.0 * glm::dot(direction, wm) * wm;
}

double cosine_to(const Vec3& direction, const Vec3& wm) {
    return std::clamp(-glm::dot(direction, wm), 0.0, 1.0);
}

// Both cosines to the normal of a boundary between dielectrics, below the critical angle.
double reflectance(double cos_theta_i, double cos_theta_t, double eta) {
    const double s = (cos_theta_i - eta * cos_theta_t) / (cos_theta_i + eta * cos_theta_t);
    const double p = (eta * cos_theta_i - cos_theta_t) / (eta * cos_theta_i + cos_theta_t);
    return 0.5 * (s * s + p * p);
}

FacetEvent meet_dielectric(const DielectricFacet& facet, const Vec3& direction, const Vec3& wm,
                           RandomStream& random) {
    const double cos_i = cosine_to(direction, wm);
    const double eta_inverse = 1.0 / facet.eta;
    const double cos2_t = 1.0 - (1.0 - cos_i * cos_i) * (eta_inverse * eta_inverse);
    const double cos_t = std::sqrt(std::max(cos2_t, 0.0));
    if (cos2_t <= 0.0 || random.uniform() < reflectance(cos_i, cos_t, facet.eta))
        return {mirror(direction, wm), Vec3{1.0}, false};
    const Vec3 refracted = direction * eta_inverse + wm * (cos_i * eta_inverse - cos_t);
    return {glm::normalize(refracted), Vec3{1.0}, true};
}

FacetEvent meet_conductor(const ConductorFacet& facet, const Vec3& direction, const Vec3& wm) {
    return {mirror(direction, wm), conductor_reflectance(cosine_to(direction, wm), facet), false};
}

FacetEvent meet_diffuse(const DiffuseFacet& facet, const Vec3& wm, RandomStream& random) {
    // A point of the unit sphere about the tip of the normal is cosine-distributed about it.
    const Vec3 sum = wm + sample_sphere(random);
    return {glm::normalize(sum), Vec3{facet.albedo[0], facet.albedo[1], facet.albedo[2]}, false};
}

}  // namespace

double dielectric_reflectance(double cos_theta_i, double eta) {
    const double sin2_theta_t = (1.0 - cos_theta_i * cos_theta_i) / (eta * eta);
    if (sin2_theta_t >= 1.0) return 1.0;
    return reflectance(cos_theta_i, std::sqrt(1.0 - sin2_theta_t), eta);
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

Vec3 conductor_reflectance(double cos_theta_i, const ConductorFacet& facet) {
    Vec3 reflectance;
    for (int channel = 0; channel < 3; ++channel) {
        const auto index = static_cast<std::size_t>(channel);
        reflectance[channel] =
            conductor_reflectance(cos_theta_i, facet.eta[index], facet.kappa[index]);
    }
    return reflectance;
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
