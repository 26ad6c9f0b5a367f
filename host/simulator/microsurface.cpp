#include "simulator/microsurface.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "simulator/roulette.h"

namespace lacquer::simulator {

namespace {

// Light along the plane of the surface arrives at this cosine: exactly along it, none would.
constexpr double kMinArrivalCosine = 1e-12;

const Surface& checked(const Surface& surface) {
    if (surface.strata.empty()) throw Error{"a surface needs at least one stratum of facets"};
    const auto* first = std::get_if<DielectricFacet>(&surface.strata.front().material);
    for (const FacetStratum& stratum : surface.strata) {
        const auto* dielectric = std::get_if<DielectricFacet>(&stratum.material);
        if ((first == nullptr) != (dielectric == nullptr) ||
            (first != nullptr && first->eta != dielectric->eta))
            throw Error{"the strata of a surface must all be dielectric with one eta, or none"};
    }
    return surface;
}

std::vector<FacetStratum> seen_from_below(std::vector<FacetStratum> strata) {
    std::reverse(strata.begin(), strata.end());
    for (FacetStratum& stratum : strata)
        if (auto* dielectric = std::get_if<DielectricFacet>(&stratum.material))
            dielectric->eta = 1.0 / dielectric->eta;
    return strata;
}

}  // namespace

SurfaceWalk::SurfaceWalk(const Surface& surface)
    : above_{surface.op, checked(surface).strata},
      below_{surface.op, seen_from_below(surface.strata)} {
    const auto* dielectric = std::get_if<DielectricFacet>(&surface.strata.front().material);
    index_matched_ = dielectric != nullptr && dielectric->eta == 1.0;
}

SurfaceRay arriving(const Vec3& direction) {
    SurfaceRay ray;
    ray.below = direction.z > 0.0;
    ray.direction = ray.below ? mirrored(direction) : direction;
    ray.direction.z = std::min(ray.direction.z, -kMinArrivalCosine);
    return ray;
}

bool turn(SurfaceRay& ray, Vec3& weight, const FacetStratum& stratum, RandomStream& random) {
    const Vec3 wm = sample_visible_normal(stratum.facets, -ray.direction, random);
    const FacetEvent event = meet_facet(stratum.material, ray.direction, wm, random);
    ray.direction = event.direction;
    if (event.refracted) {
        ray.below = !ray.below;
        ray.direction = mirrored(ray.direction);
        ray.z = turned_over(ray.z);
    }
    weight *= event.weight;
    return survives(weight, random);
}

Crossing SurfaceWalk::cross(const Vec3& direction, RandomStream& random, int max_order) const {
    return cross(direction, random, max_order,
                 [](const SurfaceRay&, const FacetStratum&, const Vec3&) {});
}

}  // namespace lacquer::simulator
