// The shader source itself, compiled as C++ in double: beside shader_float.h it tells a wrong
// formula from rounding. One of the two per translation unit.
#pragma once

#include "shading/glsl.h"
#include "shading/table_texels.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wshadow"
namespace lacquer::shader {
namespace {

using namespace glsl_double;
using Real = double;

uvec4 lq_table_texel(const int index) {
    return LACQUER_TABLE_TEXEL(index);
}

#define float double
#include "lacquer.glsl"
#undef float

}  // namespace
}  // namespace lacquer::shader
#pragma GCC diagnostic pop
