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

// The layers of the stack that this thread shades: whoever calls lq_stack_* sets them before.
thread_local const vec4* stack_rows = nullptr;

vec4 lq_stack_row(const int index) {
    return stack_rows[index];
}

#define float double
#include "lacquer.glsl"
#undef float

}  // namespace
}  // namespace lacquer::shader
#pragma GCC diagnostic pop
