// Integrals for tests: over the hemisphere by the midpoint rule in coordinates that follow a lobe,
// and over what samplers are given.
#pragma once

#include <functional>
#include <glm/vec3.hpp>

namespace lacquer::test {

// Integral over the upper hemisphere of `f(w)` per solid angle, `steps` x `steps` midpoints in
// (theta, phi). The midpoint rule is spectrally accurate in the periodic phi and second order in
// theta; theta = t^2 pi / 2 resolves lobes about the normal.
double integrate_hemisphere(const std::function<double(const glm::dvec3&)>& f, int steps);

// Mean over the unit cube of `f(u)`, at `points` evenly spread points (a lattice by powers of the
// plastic number, Roberts 2018): what the weights of a sampler average to, without its noise.
glm::dvec3 mean_over_cube(const std::function<glm::dvec3(const glm::dvec3& u)>& f, int points);

}  // namespace lacquer::test
