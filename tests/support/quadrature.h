// Integrals over the hemisphere for tests, by the midpoint rule in coordinates that follow a lobe.
#pragma once

#include <functional>
#include <glm/vec3.hpp>

namespace lacquer::test {

// Integral over the upper hemisphere of `f(w)` per solid angle, `steps` x `steps` midpoints in
// (theta, phi). The midpoint rule is spectrally accurate in the periodic phi and second order in
// theta; theta = t^2 pi / 2 resolves lobes about the normal.
double integrate_hemisphere(const std::function<double(const glm::dvec3&)>& f, int steps);

}  // namespace lacquer::test
