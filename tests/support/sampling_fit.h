// Samplers of directions against their densities.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

namespace lacquer::test {

// A direction drawn from u in [0, 1)^3; nothing where the sampler gave none that it has a density
// for.
using Sampler = std::function<std::optional<glm::dvec3>(const glm::dvec3& u)>;

// That 10^6 directions of `sampler` fit `density`, per solid angle of the upper hemisphere, in 32 x
// 64 cells of equal solid angle and one for samples without a direction: chi-square at this
// significance (see expect_fit.h). The density is integrated by midpoints, so that lobes narrower
// than about a tenth are too narrow.
void expect_sampling_fit(const Sampler& sampler,
                         const std::function<double(const glm::dvec3& wi)>& density,
                         double significance, const std::string& what);

// The same over the whole sphere, in 64 x 64 cells.
void expect_sphere_sampling_fit(const Sampler& sampler,
                                const std::function<double(const glm::dvec3& wi)>& density,
                                double significance, const std::string& what);

}  // namespace lacquer::test
