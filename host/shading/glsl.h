// The part of GLSL that the shader source uses, for a C++ compiler: GLM's vectors and functions
// under GLSL's names, once for float and once for double.
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/packing.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace lacquer::glsl {

using uint = unsigned int;
using uvec4 = glm::uvec4;
using ivec4 = glm::ivec4;

using glm::abs;
using glm::clamp;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::floor;
using glm::length;
using glm::log;
using glm::max;
using glm::min;
using glm::mix;
using glm::normalize;
using glm::pow;
using glm::sqrt;

}  // namespace lacquer::glsl

namespace lacquer::glsl_float {

using namespace glsl;
using glm::unpackHalf2x16;
using glm::vec2;
using glm::vec3;
using glm::vec4;

}  // namespace lacquer::glsl_float

namespace lacquer::glsl_double {

using namespace glsl;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;

inline vec2 unpackHalf2x16(const uint halves) {
    return vec2{glm::unpackHalf2x16(halves)};
}

}  // namespace lacquer::glsl_double
