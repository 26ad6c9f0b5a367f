// The baked tables that the library carries, and the access to them that the shader source asks
// whoever includes it for: shader_src/tables/interpolate.glsl.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>

namespace lacquer {

// In the order of shader_src/tables/texels.glsl; generated from tables/*.bin.
extern const std::size_t kTableTexelCount;
extern const glm::vec4 kTableTexels[];

}  // namespace lacquer

namespace lacquer::glsl_float {

inline glm::vec4 lq_table_texel(const int index) {
    return kTableTexels[index];
}

}  // namespace lacquer::glsl_float

namespace lacquer::glsl_double {

inline glm::dvec4 lq_table_texel(const int index) {
    return glm::dvec4{kTableTexels[index]};
}

}  // namespace lacquer::glsl_double
