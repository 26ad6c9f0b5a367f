// The model `microsurface-single` in double precision: one rough surface, uniform or not, that
// reflects or refracts what meets one of its facets; what meets more is left out.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/microsurface/rough_surface.h"
#include "reference/shading.h"

namespace lacquer::reference {

struct SingleMicrosurface : RoughSurface {};

// Throws Error as rough_surface does.
SingleMicrosurface prepare_microsurface_single(const Material& material);

// f(wi, wo), per steradian, of reflection or, with the directions on both sides, of refraction; 0
// along the surface and between equal indices, where light goes straight on.
glm::dvec3 eval(const SingleMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi.
double pdf(const SingleMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3: u.x chooses the stratum of a visible
// facet and whether a dielectric one refracts, (u.y, u.z) the facet. No weight is above 1.
Sample sample(const SingleMicrosurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fractions of light along wo that leave on the side of wo (`direct`, of a conductor `base`)
// and on the other (`transmitted`), to 1e-6.
Albedo albedo(const SingleMicrosurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
