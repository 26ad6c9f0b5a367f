// What kernels should return, from the shader source compiled in double.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "backends/backend.h"

namespace lacquer::test {

// The rows of `job`, over the float values that a backend gets. For `sample`, which may choose
// another lobe where rounding decides, use expected_at_samples().
std::vector<glm::dvec4> expected_rows(const Job& job);

// For the directions that a backend sampled (every other row of `rows`): the rows with the pdf and
// weight that belong to them.
std::vector<glm::dvec4> expected_at_samples(const Job& job, const std::vector<glm::dvec4>& rows);

}  // namespace lacquer::test
