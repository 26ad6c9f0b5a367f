// A rough surface as a random walk meets it: a half space whose opacity depends on height.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model;
//           d'Eon et al. 2023, microsurfaces with non-uniform statistics
//
// Height is measured by u = C(h) in (0, 1], the fraction of the surface below it: uniform facets
// then have a constant optical thickness Lambda(w) per unit of log u.
#pragma once

#include <vector>

#include "simulator/facet_material.h"
#include "simulator/facets.h"
#include "simulator/random.h"

namespace lacquer::simulator {

struct FacetStratum {
    double weight = 1.0;  // of the surface's area; all strata together 1
    Facets facets;
    FacetMaterial material;
};

struct Surface {
    // asymmetric: strata from the top down, each its share of u; symmetric: mixed at every height.
    Blend::Operator op = Blend::Operator::asymmetric;
    std::vector<FacetStratum> strata;
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
    bool lost = false;   // met `max_order` facets or was extinguished
};

// Walks a ray that travels along `direction` (downwards from above, upwards from below) through the
// surface until it leaves to either side. Throws Error for a surface without strata, or one that
// mixes dielectric facets with others or with a different eta: no such surface has two sides.
class SurfaceWalk {
 public:
    explicit SurfaceWalk(Surface surface);

    Crossing cross(const Vec3& direction, RandomStream& random, int max_order = kAllOrders) const;

 private:
    // The same surface seen from above or, turned over, from below.
    struct Side {
        std::vector<FacetStratum> strata;
        std::vector<double> floor;  // u of the lower boundary of each stratum
    };

    const Side& side(bool below) const { return below ? below_ : above_; }
    Crossing cross_smooth(const Vec3& direction, RandomStream& random) const;

    // Flies from `u` along `direction` in the frame of `side`: the stratum of the facet met, or
    // nullptr when the ray leaves upwards. Updates u.
    const FacetStratum* fly(const Side& side, const Vec3& direction, double& u,
                            RandomStream& random) const;
    const FacetStratum* fly_layers(const Side& side, const Vec3& direction, double& u,
                                   RandomStream& random) const;
    const FacetStratum* fly_mixture(const Side& side, const Vec3& direction, double& u,
                                    RandomStream& random) const;

    Blend::Operator op_;
    Side above_, below_;
    bool smooth_ = false;
};

}  // namespace lacquer::simulator
