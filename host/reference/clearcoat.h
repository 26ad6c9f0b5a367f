// The model `clearcoat` in double precision: the clear coat of glTF. One Fresnel factor, Schlick's
// at cos_theta_o, divides the light between the coat's lobe and the base, which is otherwise as if
// bare. Not reciprocal; the coat's medium does not absorb.
// Based on: Khronos Group 2020, KHR_materials_clearcoat (clearcoatFactor 1)
// Differs: F0 is that of the coat's own index, which glTF fixes at 1.5.
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/one_coat.h"
#include "reference/shading.h"

namespace lacquer::reference {

struct ClearcoatSurface : OneCoat {};

// Throws Error naming the JSON pointer of what the model cannot shade: a second layer, a medium
// that scatters, a blended microsurface.
ClearcoatSurface prepare_clearcoat(const Material& material);

// f(wi, wo), per steradian; 0 unless both directions are above the surface.
glm::dvec3 eval(const ClearcoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi; 0 unless both directions are above.
double pdf(const ClearcoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3 (one_coat.h), with the probability
// F / (F + (1 - F) B) for the coat, where F is Schlick's factor and B the base's albedo or Fresnel
// reflectance at cos_theta_o, averaged over the channels.
Sample sample(const ClearcoatSurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fraction of light from every direction that is sent to wo, to 1e-7; 0 unless wo is above.
Albedo albedo(const ClearcoatSurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
