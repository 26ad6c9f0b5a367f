// The lobes that operators act on: simulated walks through one surface or slab, and the GGX lobes
// that stand for them.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "simulator/estimator.h"
#include "simulator/microsurface.h"
#include "study/layered/disk_moments.h"

namespace lacquer::study {

// The direction that light at `cosine` comes from, and that in which it travels downwards, its x
// positive.
inline glm::dvec3 downwards(double cosine) {
    return {std::sqrt(1.0 - cosine * cosine), 0.0, -cosine};
}

inline glm::dvec3 turned_over(const glm::dvec3& w) {
    return {w.x, w.y, -w.z};
}

// Isotropic facets that reflect all light.
simulator::SurfaceWalk mirrors(Ndf ndf, double alpha);

// Isotropic GGX facets of a dielectric; `eta` = ior below / ior above.
simulator::SurfaceWalk dielectric(double alpha, double eta);

// Light after a walk; of weight 0 where it is lost.
struct Ray {
    glm::dvec3 direction{0.0};
    double weight = 0.0;
};

// Of what `walk(random)` returns, a Ray.
template <typename Walk>
Spread simulate_spread(const simulator::RunOptions& options, const Walk& walk) {
    struct Tally {
        DiskMoments moments;
        std::uint64_t count = 0;
        void merge(const Tally& other) { moments.merge(other.moments); }
    };
    const auto tally =
        simulator::run_walks<Tally>(options, [&](simulator::RandomStream& random, Tally& sum) {
            const Ray ray = walk(random);
            if (ray.weight > 0.0) sum.moments.add(ray.weight, ray.direction);
        });
    return tally.moments.spread(static_cast<double>(tally.count));
}

// The n-th of `count` directions that fill the GGX lobe of `alpha` evenly, about the mirror
// direction of light at `cosine`, and its weight: what meets one facet, as a lobe of a model.
Ray lobe_ray(double alpha, double cosine, int n, int count);

// Mean and width of that lobe, of light at `cosine`.
Spread ggx_lobe(double alpha, double cosine);

}  // namespace lacquer::study
