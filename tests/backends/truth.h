// What kernels should return.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "backends/backend.h"

namespace lacquer::test {

using Rows = std::vector<glm::dvec4>;

// The rows that should stand in place of `rows`, which a backend returned for `job`: the
// reference's, except that
// - for `sample` the density and weight belong to the directions in `rows`, since rounding may
//   decide which lobe is chosen;
// - for `albedo` the shader source compiled in double takes the reference's place, whose integral
//   is more precise than the kernel's sum of a few samples.
Rows expected_rows(const Job& job, const Rows& rows);

}  // namespace lacquer::test
