// A material as the rows that shader_src/kernels/microsurface_rows.glsl reads.
#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "core/model.h"
#include "lacquer/material.h"
#include "shading/several_facets_rows.h"

namespace lacquer {

inline constexpr std::size_t kMicrosurfaceRows = 2 + 3 * kMaxStrata;  // LQ_MICROSURFACE_ROWS there

// Throws Error naming the material and the JSON pointer of what `model` cannot shade.
std::array<glm::vec4, kMicrosurfaceRows> pack_microsurface(const Material& material, Model model);

// What meets several facets of it, for kernels/several_facets_rows.glsl. Throws likewise.
std::array<glm::vec4, kSeveralFacetsRows> pack_several_facets(const Material& material,
                                                              Model model);

}  // namespace lacquer
