// Light on an explicit rough surface: a periodic Gaussian heightfield, stretched stratum by
// stratum, its facets of any material. Based on: d'Eon et al. 2023, Microfacet Theory for
// Non-Uniform Heightfields, section 4
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "heightfield/gaussian_field.h"
#include "heightfield/ray_scene.h"
#include "simulator/microsurface.h"

namespace lacquer::heightfield {

// How a ray's way among the facets ended.
struct Trip : simulator::Crossing {
    bool stray = false;  // lost by the geometry: see Heightfield::cross
};

class Heightfield {
 public:
    // `strata` from the top down, as of an asymmetric blend of Beckmann facets: a Gaussian surface
    // has no others. Stretching keeps the ratio of their alphas, which must be the same in all
    // strata. Surfaces of one seed and different `number` are independent. Throws Error.
    Heightfield(std::span<const simulator::FacetStratum> strata, const FieldGrid& grid,
                std::uint64_t seed, std::uint64_t number);

    // Sends a ray along `direction` (downwards from above, upwards from below) to a random place
    // and follows it until it leaves to either side. A stray found a gap between facets, or no end
    // among the copies of the tile; it is lost too.
    Trip cross(const simulator::Vec3& direction, simulator::RandomStream& random,
               int max_order = simulator::kAllOrders) const;

    // The first facet that a ray above the surface meets, if any; `origin` anywhere along x and y.
    std::optional<RayHit> look(const simulator::Vec3& origin,
                               const simulator::Vec3& direction) const;

    const FacetMesh& mesh() const { return scene_.mesh(); }

 private:
    struct Ray;
    enum class End { facet, away, stray };

    simulator::Vec3 start(const simulator::Vec3& direction, simulator::RandomStream& random) const;
    End fly(Ray& ray) const;
    bool turn(Ray& ray, simulator::Vec3& weight, simulator::RandomStream& random) const;

    std::vector<simulator::FacetMaterial> from_above_, from_below_;  // per stratum
    RayScene scene_;
};

}  // namespace lacquer::heightfield
