// Ending walks that carry next to nothing.
#pragma once

#include <algorithm>

#include "simulator/sampling.h"

namespace lacquer::simulator {

// Light fainter than this in every channel is ended at random.
inline constexpr double kFaint = 1e-2;

// False ends the walk. Faint walks that go on are made as much brighter as others are ended, which
// keeps the expectation; a walk that carries nothing always ends.
inline bool survives(Vec3& weight, RandomStream& random) {
    const double strongest = std::max({weight.x, weight.y, weight.z});
    if (strongest >= kFaint) return true;
    if (random.uniform() * kFaint >= strongest) return false;
    weight *= kFaint / strongest;
    return true;
}

}  // namespace lacquer::simulator
