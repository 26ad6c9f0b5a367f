// What balls and plates of the suite are lit by: surroundings whose edges a smooth surface mirrors
// and a rough one blurs.
#pragma once

#include <glm/vec3.hpp>

namespace lacquer::study {

// Radiance, grey, that comes from the unit direction `w`: x to the right, y up, z to the camera.
using Surroundings = double (*)(const glm::dvec3& w);

// A room: floor and wall in half light, a window with four panes above the camera's left shoulder,
// a larger one at the back and a narrow lamp to the right. The edges are one or two degrees wide,
// so that one ray per pixel draws them.
double studio(const glm::dvec3& w);

// 1 from everywhere.
double white_furnace(const glm::dvec3& w);

}  // namespace lacquer::study
