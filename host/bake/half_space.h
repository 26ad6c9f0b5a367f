// A GGX surface as its bake meets it: opacity, visible normals and escape of a Smith half space.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model;
//           Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps
//
// Height is u = C(h) in (0, 1], the fraction of the surface below it. The simulator
// (host/simulator) does the same for any surface and knows nothing of this code: it judges what is
// baked here.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>

namespace lacquer::bake {

using Vec3 = glm::dvec3;

// Smith's Lambda of isotropic GGX: positive upwards, at most -1 downwards.
inline double ggx_lambda(double alpha, const Vec3& w) {
    const double tan2 = (w.x * w.x + w.y * w.y) / std::max(w.z * w.z, 1e-300);
    const double above = 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
    return w.z > 0.0 ? above : -1.0 - above;
}

// The facet met by a ray from w (to either side), for two numbers of the unit square. `phi_number`
// 0 and 1 both mean the plane of w; 0.5 mirrors nothing.
inline Vec3 visible_normal(double alpha, const Vec3& w, double phi_number, double height_number) {
    const Vec3 stretched = glm::normalize(Vec3{alpha * w.x, alpha * w.y, w.z});
    const double phi = 2.0 * std::numbers::pi * phi_number;
    const double z = (1.0 - height_number) * (1.0 + stretched.z) - stretched.z;
    const double radius = std::sqrt(std::clamp(1.0 - z * z, 0.0, 1.0));
    const Vec3 half = Vec3{radius * std::cos(phi), radius * std::sin(phi), z} + stretched;
    return glm::normalize(Vec3{alpha * half.x, alpha * half.y, std::max(half.z, 0.0)});
}

inline Vec3 mirror(const Vec3& direction, const Vec3& wm) {
    return direction - 2.0 * glm::dot(direction, wm) * wm;
}

// Fresnel's equations at a facet that is met under cos_theta_i; cos_theta_t is 0 where all light
// is reflected.
struct FresnelSplit {
    double reflectance = 1.0;
    double cos_theta_t = 0.0;
};

inline FresnelSplit dielectric_split(double cos_theta_i, double eta) {
    const double cos2_theta_t = 1.0 - (1.0 - cos_theta_i * cos_theta_i) / (eta * eta);
    if (cos2_theta_t <= 0.0) return {};
    const double cos_theta_t = std::sqrt(cos2_theta_t);
    const double s = (cos_theta_i - eta * cos_theta_t) / (cos_theta_i + eta * cos_theta_t);
    const double p = (eta * cos_theta_i - cos_theta_t) / (eta * cos_theta_i + cos_theta_t);
    return {0.5 * (s * s + p * p), cos_theta_t};
}

}  // namespace lacquer::bake
