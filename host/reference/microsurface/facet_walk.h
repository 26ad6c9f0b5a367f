// A ray of light among the facets of a rough surface: its flights between them and what each makes
// of it.
// Based on: Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model;
//           d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
//
// A ray is in the frame of the side of the surface where it is: upwards it may leave. Depth is
// -log C, C the fraction of the surface below it: a ray then meets facets of a stratum at a
// constant rate, Lambda upwards and 1 + Lambda downwards.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

#include "reference/microsurface/single_scattering.h"

namespace lacquer::reference {

// Both sides of a surface, that of the light first; of a conductor the second is not used.
using TwoSides = std::array<RoughSide, 2>;

struct FacetRay {
    glm::dvec3 w;  // where it travels, unit
    double depth = 0.0;
    std::size_t side = 0;     // index into TwoSides
    std::size_t stratum = 0;  // of the facet that it met last, counted on its side
};

// A ray from w, above the first side, that enters the surface.
FacetRay entering(const glm::dvec3& w);

// Flies to the next facet; false: it left the surface. Of u in [0, 1)^2, u.x is for the distance
// and u.y for the stratum of a symmetric blend.
bool fly(const TwoSides& sides, FacetRay& ray, const glm::dvec2& u);

// The chance to leave along w, above its side, from the depth of the ray.
double escape(const RoughSide& side, const glm::dvec3& w, double depth);

// The same height measured from the other side.
double turned_depth(double depth);

// Turns a ray at the facet it met by one of its visible normals, (u.x, u.y), reflected or, as u.z
// chooses by Fresnel's reflectance, refracted; returns what a conductor's facet leaves of the
// light.
glm::dvec3 turn(const TwoSides& sides, FacetRay& ray, const glm::dvec3& u);

// Towards one direction out of the surface: the density per solid angle with which the facet that a
// ray met sends it there and it leaves, without what a conductor takes; and what that leaves.
struct Connection {
    double density = 0.0;
    glm::dvec3 reflectance{1.0};
};

// `w` is above the side number `side`.
Connection connection(const TwoSides& sides, const FacetRay& ray, const glm::dvec3& w,
                      std::size_t side);

// The ray that comes back to the facet that `ray` was turned by.
FacetRay reversed(const FacetRay& ray);

}  // namespace lacquer::reference
