// Bounds of directions inside a stack, and directions in the plane of incidence.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace lacquer::reference {

// Nearer to grazing lobes have no width to speak of: means are kept above.
inline constexpr double kLeastCosine = 0.014;
inline constexpr double kMostSine = 0.9999;

// The unit vector of this cosine, in [0, 1], in the plane of x and z.
inline glm::dvec3 direction_of(double cosine) {
    return {std::sqrt(std::max(1.0 - cosine * cosine, 0.0)), 0.0, cosine};
}

}  // namespace lacquer::reference
