#include "simulator/next_event.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::simulator {

namespace {

// Density of the facet met from w by its normal wm.
double visible_density(const Facets& facets, const Vec3& w, const Vec3& wm) {
    return std::max(0.0, glm::dot(w, wm)) * normal_density(facets, wm) / projected_area(facets, w);
}

// Mirrors send light from w to `target` where their normal is halfway.
double mirror_density(const Facets& facets, const Vec3& w, const Vec3& wm) {
    return visible_density(facets, w, wm) / (4.0 * glm::dot(w, wm));
}

// Walter et al. 2007, Eq. 17; target on the other side of the facet.
double refraction_density(const Facets& facets, double eta, const Vec3& w, const Vec3& target) {
    Vec3 wm = glm::normalize(w + eta * target);
    if (wm.z < 0.0) wm = -wm;
    const double cos_i = glm::dot(w, wm);
    const double cos_t = glm::dot(target, wm);
    if (cos_i <= 0.0 || cos_t >= 0.0) return 0.0;
    const double jacobian = eta * eta * -cos_t / ((cos_i + eta * cos_t) * (cos_i + eta * cos_t));
    return visible_density(facets, w, wm) * (1.0 - dielectric_reflectance(cos_i, eta)) * jacobian;
}

// What light from w leaves with from a facet of the stratum: towards `target`, per solid angle.
// Both in the frame of the side of w; downward targets are reached by refraction alone.
Vec3 facet_density(const FacetStratum& stratum, const Vec3& w, const Vec3& target,
                   RandomStream& random) {
    const Facets& facets = stratum.facets;
    const auto* dielectric = std::get_if<DielectricFacet>(&stratum.material);
    if (target.z <= 0.0)
        return Vec3{dielectric ? refraction_density(facets, dielectric->eta, w, target) : 0.0};
    if (const auto* diffuse = std::get_if<DiffuseFacet>(&stratum.material)) {
        const Vec3 wm = sample_visible_normal(facets, w, random);
        const double density = std::max(0.0, glm::dot(wm, target)) / std::numbers::pi;
        return density * Vec3{diffuse->albedo[0], diffuse->albedo[1], diffuse->albedo[2]};
    }
    const Vec3 wm = glm::normalize(w + target);
    if (glm::dot(w, wm) <= 0.0) return Vec3{0.0};
    const double cosine = std::min(glm::dot(w, wm), 1.0);
    const double density = mirror_density(facets, w, wm);
    if (dielectric) return Vec3{density * dielectric_reflectance(cosine, dielectric->eta)};
    return density * conductor_reflectance(cosine, std::get<ConductorFacet>(stratum.material));
}

}  // namespace

bool has_density(const SurfaceWalk& surface) {
    return std::ranges::all_of(surface.side(false).strata(), [](const FacetStratum& stratum) {
        return stratum.facets.alpha_x > 0.0 && stratum.facets.alpha_y > 0.0;
    });
}

Vec3 next_event_density(const SurfaceWalk& surface, const Vec3& wi, const Vec3& wo,
                        RandomStream& random, int max_order) {
    Vec3 sum{0.0};
    surface.cross(
        -wo, random, max_order,
        [&](const SurfaceRay& ray, const FacetStratum& stratum, const Vec3& weight) {
            const Vec3 target = ray.below ? mirrored(wi) : wi;
            const bool stays = target.z > 0.0;
            const double escape =
                stays ? surface.side(ray.below).escape(target, ray.z)
                      : surface.side(!ray.below).escape(mirrored(target), turned_over(ray.z));
            if (escape > 0.0)
                sum += escape * weight * facet_density(stratum, -ray.direction, target, random);
        });
    return sum;
}

}  // namespace lacquer::simulator
