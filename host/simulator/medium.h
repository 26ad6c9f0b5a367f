// Light between two interfaces: absorbed along its path, scattered by Henyey and Greenstein's phase
// function.
#pragma once

#include "lacquer/material.h"
#include "simulator/random.h"
#include "simulator/sampling.h"

namespace lacquer::simulator {

// A medium between two planes one `thickness` apart; coefficients per unit of thickness.
struct Slab {
    Vec3 sigma_a{0.0};
    Vec3 sigma_s{0.0};
    double g = 0.0;
    double thickness = 1.0;
    bool opaque[3] = {false, false, false};  // tau 0: nothing of that channel gets across

    bool scatters() const { return sigma_s != Vec3{0.0} && thickness > 0.0; }
};

Slab make_slab(const Medium& medium);

// How a ray left a slab that it had entered at one of its planes.
struct Passage {
    Vec3 direction;
    Vec3 weight{1.0};
    bool down = false;  // left through the lower plane
    bool lost = false;  // absorbed within
};

// Follows a ray that enters along `direction` through the plane it comes from.
Passage pass_slab(const Slab& slab, const Vec3& direction, RandomStream& random);

// Direction after scattering by Henyey and Greenstein's phase function of mean cosine g.
Vec3 sample_phase(const Vec3& direction, double g, RandomStream& random);

}  // namespace lacquer::simulator
