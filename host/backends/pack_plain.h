// A material as the rows that shader_src/kernels/model_plain.glsl reads.
#pragma once

#include <array>
#include <glm/vec4.hpp>

#include "lacquer/material.h"

namespace lacquer {

inline constexpr std::size_t kPlainRows = 5;  // LQ_PLAIN_ROWS

// Throws Error naming the material and the JSON pointer of a blended microsurface.
std::array<glm::vec4, kPlainRows> pack_plain(const Material& material);

}  // namespace lacquer
