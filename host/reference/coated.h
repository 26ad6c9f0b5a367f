// The model `coated` in double precision: one rough dielectric coat over an absorbing medium over a
// Lambertian base, with all reflections between them.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces
//
// Exact but for the tables and for the coat's reflections of more than one facet, whose direction
// is taken as diffuse; for anisotropic and Beckmann coats see equivalent_alpha.h.
#pragma once

#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/coat.h"
#include "reference/coated_base.h"
#include "reference/shading.h"
#include "tables/energy_tables.h"

namespace lacquer::reference {

struct CoatedSurface {
    Coat coat;
    CoatedBase base;
};

// Throws Error naming the JSON pointer of what the model cannot shade: anything but one layer over
// a Lambertian base, a scattering medium.
CoatedSurface prepare_coated(const Material& material, const EnergyTables& tables, BaseLobe shape);

// f(wi, wo), per steradian; 0 unless both directions are above the surface.
glm::dvec3 eval(const CoatedSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// Density per solid angle with which `sample` chooses wi; 0 unless both directions are above.
double pdf(const CoatedSurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3: u.x chooses the coat with
// probability C / (C + B), where C and B are the albedos of coat and base at wo, averaged over the
// channels, kept within [kMinChoice, 1 - kMinChoice] where both have some; and within the coat what
// met one facet (coat.h). (u.y, u.z) choose the direction.
Sample sample(const CoatedSurface& surface, const glm::dvec3& wo, const glm::dvec3& u);

// The fraction of light from every direction that is sent to wo, by eq. 3; 0 unless wo is above.
Albedo albedo(const CoatedSurface& surface, const glm::dvec3& wo);

}  // namespace lacquer::reference
