// Directional albedo of a material, split by what the light met.
#pragma once

#include <array>
#include <cstdint>

#include "simulator/rgb_estimate.h"
#include "simulator/stack.h"

namespace lacquer::simulator {

struct AlbedoEstimate {
    RgbEstimate direct, base, transmitted, total;  // total = direct + base, reflected in all
    std::array<RgbEstimate, 3> orders;             // reflected after 1, 2, 3 facets
    std::uint64_t samples = 0;                     // walks made; fewer than asked when stopped
};

// Fraction of light that a material sends to the direction of cosine `cos_theta_o` (in [0, 1], in
// the plane of x) from all directions, or by reciprocity where light arriving from there goes.
AlbedoEstimate estimate_albedo(const StackWalk& stack, double cos_theta_o,
                               const RunOptions& options);

}  // namespace lacquer::simulator
