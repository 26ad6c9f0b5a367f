// Light refracted once by the facets of a rough interface. Directions: wo above the surface, wi
// below; `eta` = index of wi's side over that of wo's side, not 1.
// Based on: Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace lacquer::reference {

// The normal, above the surface, that refracts wo into wi. Walter et al. 2007, Eq. 16. Nothing
// where no facet does.
std::optional<glm::dvec3> refraction_halfway(const glm::dvec3& wi, const glm::dvec3& wo,
                                             double eta);

// wo refracted by a facet of normal wm that faces it; nothing beyond the critical angle. It may
// point above the surface.
std::optional<glm::dvec3> refracted(const glm::dvec3& wo, const glm::dvec3& wm, double eta);

// d wm / d wi: solid angle of the normals that refract wo into a solid angle of wi. Walter et al.
// 2007, Eq. 17.
double refraction_jacobian(const glm::dvec3& wi, const glm::dvec3& wo, const glm::dvec3& wm,
                           double eta);

}  // namespace lacquer::reference
