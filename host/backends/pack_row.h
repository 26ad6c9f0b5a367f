// Parts of a material as rows of a shader's buffer.
#pragma once

#include <glm/vec4.hpp>

#include "lacquer/material.h"

namespace lacquer {

// (alpha x, alpha y, `third`, ndf), the ndf as LQ_NDF_* of shader_src/microfacet/facets.glsl.
glm::vec4 facets_row(const Microsurface& facets, double third);

// Infinities, which not every language has, become the largest float.
glm::vec4 colour_row(const Rgb& colour, double fourth = 0.0);

}  // namespace lacquer
