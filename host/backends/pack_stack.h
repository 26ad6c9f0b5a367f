// A material as the rows that shader_src/kernels/model_stack.glsl reads.
#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer {

// LQ_MODEL_ROWS there.
inline constexpr std::size_t kStackRows = 3 + (3 + kMaxStrata) * kMaxLayers;

// Throws Error naming the material and the JSON pointer of what `model` cannot shade.
std::array<glm::vec4, kStackRows> pack_stack(const Material& material, Model model);

}  // namespace lacquer
