// The model `plain` in double precision: the single reflections of the top interface plus the base
// as if it were bare, without transport between them.
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/one_coat.h"
#include "reference/shading.h"

namespace lacquer::reference {

struct PlainSurface : OneCoat {};

// What `plain` takes from a material: layers below the first and all media are not transported, and
// diffuse facets are shaded as Lambertian. Throws Error naming the JSON pointer of a blended
// microsurface that it would have to shade.
PlainSurface prepare_plain(const Material& material);

// f(wi, wo), per steradian; 0 unless both directions are above the surface.
glm::dvec3 eval(const PlainSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi; 0 unless both directions are above.
double pdf(const PlainSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3 (one_coat.h), with the probability
// F / (F + B) for the coat, where F is the coat's Fresnel reflectance at cos_theta_o and B the
// base's albedo or Fresnel reflectance there, averaged over the channels.
Sample sample(const PlainSurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fraction of light from every direction that is sent to wo, to 1e-7; 0 unless wo is above.
Albedo albedo(const PlainSurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
