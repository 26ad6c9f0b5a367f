// The baked tables that the library carries.
#pragma once

#include <cstddef>
#include <glm/ext/vector_uint4.hpp>

namespace lacquer {

// In the order of shader_src/tables/texels.glsl; generated from tables/*.bin.
extern const std::size_t kTableTexelCount;
extern const glm::uvec4 kTableTexels[];

// What lq_table_texel of the shader source returns; who wants it to return something else defines
// this before including shader_float.h or shader_double.h.
#ifndef LACQUER_TABLE_TEXEL
#define LACQUER_TABLE_TEXEL(index) kTableTexels[index]
#endif

}  // namespace lacquer
