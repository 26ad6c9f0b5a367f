// What meets several facets of a rough surface, found out by the shader source in double, as the
// rows that shader_src/kernels/several_facets_rows.glsl reads.
#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "shading/microsurface_parameters.h"

namespace lacquer {

// Coefficients in two planes, averages and what is let through; of two sides, and the turning.
inline constexpr std::size_t kSeveralFacetsSideRows = 2 * 7 + 2;
inline constexpr std::size_t kSeveralFacetsRows = 1 + 2 * kSeveralFacetsSideRows;

std::array<glm::vec4, kSeveralFacetsRows> several_facets_rows(
    const MicrosurfaceParameters& parameters);

}  // namespace lacquer
