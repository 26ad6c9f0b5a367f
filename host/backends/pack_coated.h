// A material as the rows that shader_src/kernels/model_coated.glsl reads.
#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

inline constexpr std::size_t kCoatedRows = 3;  // LQ_MODEL_ROWS there

// `model` is coated_ggx or coated_exact. Throws Error naming the material and the JSON pointer of
// what they cannot shade.
std::array<glm::vec4, kCoatedRows> pack_coated(const Material& material, Model model);

}  // namespace lacquer
