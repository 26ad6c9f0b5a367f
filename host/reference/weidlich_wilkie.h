// The model `weidlich-wilkie` in double precision: light enters and leaves through the same facet
// of the coat, is refracted there, crosses the coat's medium twice and meets the base once.
// Reciprocal. As in the paper, neither the solid angle that refraction compresses nor light
// reflected back to the base from within are accounted for.
// Based on: Weidlich and Wilkie 2007, Arbitrarily Layered Micro-Facet Surfaces
// Differs: the coat's thickness, whose direction the paper leaves open, is measured along the
// facet's normal, the facets being much wider than the coat is thick.
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/one_coat.h"
#include "reference/shading.h"

namespace lacquer::reference {

struct WeidlichWilkieSurface : OneCoat {};

// Throws Error naming the JSON pointer of what the model cannot shade: a second layer, a medium
// that scatters, a blended microsurface.
WeidlichWilkieSurface prepare_weidlich_wilkie(const Material& material);

// f(wi, wo), per steradian; 0 unless both directions are above the surface.
glm::dvec3 eval(const WeidlichWilkieSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi; 0 unless both directions are above.
double pdf(const WeidlichWilkieSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3 (one_coat.h), with the probability
// F / (F + P B) for the coat, where F is the coat's Fresnel reflectance at cos_theta_o, P what
// becomes of light that passes a facet there twice, unshadowed, and B the base's albedo or Fresnel
// reflectance for the refracted angle; P B averaged over the channels.
Sample sample(const WeidlichWilkieSurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fraction of light from every direction that is sent to wo, to 1e-6; 0 unless wo is above.
Albedo albedo(const WeidlichWilkieSurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
