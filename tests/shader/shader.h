// The shader source in the precision that this test program is compiled for.
#pragma once

#ifdef LACQUER_TEST_FLOAT
// The tests' own literals turn into floats too, which is harmless but for this warning.
#pragma GCC diagnostic ignored "-Wconversion"
#include "shading/shader_float.h"
#else
#include "shading/shader_double.h"
#endif

#include <limits>

namespace lacquer::shader_test {

using shader::Real;
using shader::vec2;
using shader::vec3;

// One rounding of a Real.
inline constexpr double kRounding = 0.5 * static_cast<double>(std::numeric_limits<Real>::epsilon());

// Absolute error that a chain of about `count` roundings of values near 1 may reach.
constexpr double roundings(double count) {
    return count * kRounding;
}

// The Real nearest to a number computed in double: literals are floats in the float build.
inline Real real(double x) {
    return static_cast<Real>(x);
}

// A unit direction from spherical angles in radians, computed in double and rounded.
inline vec3 direction(double theta, double phi) {
    return {real(std::sin(theta) * std::cos(phi)), real(std::sin(theta) * std::sin(phi)),
            real(std::cos(theta))};
}

inline glm::dvec3 widen(const vec3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace lacquer::shader_test
