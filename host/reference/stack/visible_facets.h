// A few facets that stand for all that a direction sees of a rough GGX surface.
// Based on: Dupuy and Benyoub 2023, Sampling Visible GGX Normals with Spherical Caps
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

namespace lacquer::reference {

// To one side of the plane of incidence; the other side mirrors it.
inline constexpr std::size_t kFacetAzimuths = 3, kFacetHeights = 5;
using VisibleFacets = std::array<glm::dvec3, kFacetAzimuths * kFacetHeights>;

// Normals of equal weight: midpoints of the visible normals' sampling square. `w` is above the
// surface, in the plane of x and z; alpha > 0.
VisibleFacets visible_facets(const glm::dvec3& w, double alpha);

// The unit vector of this cosine, in [0, 1], in the plane of x and z.
glm::dvec3 direction_of(double cos_theta);

}  // namespace lacquer::reference
