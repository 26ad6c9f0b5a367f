// The baked tables as shaders read them: texels of four numbers, one array after the other as
// shader_src/tables/texels.glsl says.
#pragma once

#include <array>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "tables/energy_tables.h"

namespace lacquer {

// Nodes of an array in the order of their axes, the channels of each in consecutive texels, the
// last filled up with 0. Every number is one that a half can hold.
std::vector<glm::vec4> pack_texels(const std::array<Table, kTableNames.size()>& tables);

// Columns of the texture that holds the texels row after row: LQ_TABLE_COLUMNS of the shader source.
inline constexpr std::size_t kTexelColumns = 128;

// Those of the tables that the program ships with, read once. Throws Error naming the file that is
// missing or damaged.
std::span<const glm::vec4> shipped_texels();

}  // namespace lacquer
