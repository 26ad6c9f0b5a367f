// A rough surface as a random walk of light meets it.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model;
//           d'Eon et al. 2023, microsurfaces with non-uniform statistics
#pragma once

#include <vector>

#include "simulator/surface_side.h"

namespace lacquer::simulator {

struct Surface {
    Blend::Operator op = Blend::Operator::asymmetric;
    std::vector<FacetStratum> strata;  // asymmetric: from the top down
};

// A walk ends after this many facets; whatever it still carries is lost. High enough that a
// lossless rough surface loses less than 1e-9.
inline constexpr int kAllOrders = 4096;

// How a walk left a surface.
struct Crossing {
    Vec3 direction;      // travelling away from the surface
    Vec3 weight{1.0};    // what is left of the light, per channel
    int order = 0;       // facets met
    bool below = false;  // left to the lower side
    bool lost = false;   // met more than the wanted facets, or was absorbed
};

// A ray within a walk: in the frame of the side where it is, where it starts downwards at the top
// and leaves upwards.
struct SurfaceRay {
    Vec3 direction;
    double z = 0.0;  // see surface_side.h
    bool below = false;
};

class SurfaceWalk {
 public:
    // Throws Error for a surface without strata, or one that mixes dielectric facets with others or
    // with a different eta: no such surface has two sides.
    explicit SurfaceWalk(const Surface& surface);

    // Walks a ray that travels along `direction` (downwards from above, upwards from below) through
    // the surface until it leaves to either side.
    Crossing cross(const Vec3& direction, RandomStream& random, int max_order = kAllOrders) const;

    // The same; `on_facet(ray, stratum, weight)` is told of each facet met, before the facet turns
    // the ray.
    template <typename OnFacet>
    Crossing cross(const Vec3& direction, RandomStream& random, int max_order,
                   const OnFacet& on_facet) const;

    // The surface seen from above or, turned over, from below.
    const SurfaceSide& side(bool below) const { return below ? below_ : above_; }

 private:
    SurfaceSide above_, below_;
    bool index_matched_;
};

// From the frame of one side to that of the other. The populations are even in slope, so that
// mirroring serves as well as turning over.
inline Vec3 mirrored(const Vec3& w) {
    return {w.x, w.y, -w.z};
}

// A ray that arrives at the top of the side it comes from.
SurfaceRay arriving(const Vec3& direction);

// Dielectric facets of eta 1 do nothing, however many a grazing ray meets.
inline Crossing unchanged(const SurfaceRay& ray) {
    return {ray.below ? mirrored(ray.direction) : ray.direction, Vec3{1.0}, 0, !ray.below, false};
}

// Turns a ray by a facet, which may send it to the other side. False: its light is all absorbed.
bool turn(SurfaceRay& ray, Vec3& weight, const FacetStratum& stratum, RandomStream& random);

template <typename OnFacet>
Crossing SurfaceWalk::cross(const Vec3& direction, RandomStream& random, int max_order,
                            const OnFacet& on_facet) const {
    SurfaceRay ray = arriving(direction);
    if (index_matched_) return unchanged(ray);
    Crossing crossing;
    while (const FacetStratum* stratum = side(ray.below).fly(ray.direction, ray.z, random)) {
        crossing.lost = crossing.order == max_order;
        if (crossing.lost) break;
        on_facet(ray, *stratum, crossing.weight);
        ++crossing.order;
        crossing.lost = !turn(ray, crossing.weight, *stratum, random);
        if (crossing.lost) break;
    }
    crossing.below = ray.below;
    crossing.direction = ray.below ? mirrored(ray.direction) : ray.direction;
    return crossing;
}

}  // namespace lacquer::simulator
