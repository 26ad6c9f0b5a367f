// What the first facets that light meets leave of it to others: by quadrature over them
// (facet_points.h), for directions in the planes of x and y.
#pragma once

#include <glm/vec3.hpp>

#include "reference/microsurface/single_scattering.h"

namespace lacquer::reference {

// Fractions of light along w.
struct LeftOver {
    double met{0.0};       // meets another facet, if the first absorbs nothing
    glm::dvec3 kept{0.0};  // the same without what the first absorbs
};

LeftOver left_over(const RoughSide& side, const glm::dvec3& w);

}  // namespace lacquer::reference
