// The baked tables as shaders read them: texels of eight halves, one array after the other as
// shader_src/tables/texels.glsl says.
#pragma once

#include <array>
#include <glm/ext/vector_uint4.hpp>
#include <span>
#include <vector>

#include "tables/energy_tables.h"

namespace lacquer {

// Eight halves, two to a component, the first in its lower bits.
using TableTexel = glm::uvec4;

// Nodes of an array in the order of their axes, what belongs to one node in consecutive texels.
std::vector<TableTexel> pack_texels(const std::array<Table, kTableNames.size()>& tables);

// Columns of the texture that holds the texels row after row: LQ_TABLE_COLUMNS of the shader
// source.
inline constexpr std::size_t kTexelColumns = 128;

// Those of the tables that the program ships with, read once. Throws Error naming the file that is
// missing or damaged.
std::span<const TableTexel> shipped_texels();

}  // namespace lacquer
