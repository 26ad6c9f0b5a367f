// The model `openpbr-coat` in double precision: below the coat's single reflections lies the base,
// made rougher by the coat, darkened by light that goes back and forth below it, attenuated along
// the refracted paths and scaled by what the coat does not reflect to the viewer. Not reciprocal.
// Based on: OpenPBR Surface specification 1.1, sections on layering and on the coat
// (coat_weight 1, coat_darkening 1)
// Differs: the coat's directional albedo E_coat is taken as the Fresnel reflectance of a smooth
// coat; paths through the coat are at most kLongestPath long, also beyond the critical angle.
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/one_coat.h"
#include "reference/shading.h"

namespace lacquer::reference {

// Facets of the base are those below the coat, made rougher by it.
struct OpenpbrCoatSurface : OneCoat {
    glm::dvec3 base_albedo{0.0};       // at normal incidence, below the coat
    double base_roughness = 1.0;       // perceptual, of the base itself; 1 for a Lambertian
    double diffuse_reflectance = 0.0;  // K_r, of the coat from below
};

// Throws Error naming the JSON pointer of what the model cannot shade: a second layer, a medium
// that scatters, a blended microsurface.
OpenpbrCoatSurface prepare_openpbr_coat(const Material& material);

// f(wi, wo), per steradian; 0 unless both directions are above the surface.
glm::dvec3 eval(const OpenpbrCoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi; 0 unless both directions are above.
double pdf(const OpenpbrCoatSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3 (one_coat.h), with the probability
// F / (F + A E_b) for the coat, where F is the coat's Fresnel reflectance at cos_theta_o, A all
// that attenuates light from the normal on its way to wo and E_b the base's albedo at normal
// incidence; A E_b averaged over the channels.
Sample sample(const OpenpbrCoatSurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fraction of light from every direction that is sent to wo, to 1e-6; 0 unless wo is above.
Albedo albedo(const OpenpbrCoatSurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
