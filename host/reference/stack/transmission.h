// The light that leaves a stack without a base below, as GGX lobes: those of reflections, turned to
// the lower side, about the direction in which most light goes on. There are two, of light that
// went straight down and of light that was reflected in between, which is wider and by absorption
// darker.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, Eq. 39 and section 4.2 (transmission as a fake reflection)
//
//   f(wi, wo) = E D(h) G2(wi', m) / (4 |cos_theta_i| cos_theta_m S),   h halfway between wi' and m
//
// with E the share of light along wo that leaves below in this lobe, wi' the mirror image of wi
// above the surface, m the direction opposite to the lobe's middle, and S what single reflections
// by facets have of all light: the integral of f |cos_theta_i| over the lower side is E.
//
// That is f for radiance over the square of the index, which refraction keeps. For radiance, as
// renderers want it that trace from the viewer, multiply by (index of the exterior / index
// below)^2; for plates, with the same medium on both sides, by 1.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/stack/beam.h"
#include "tables/energy_tables.h"

namespace lacquer::reference {

struct TransmissionLobe {
    glm::dvec3 energy{0.0};  // E
    double alpha = 1.0;
    double mirrored = 1.0;           // S
    glm::dvec3 from{0.0, 0.0, 1.0};  // m
};

// Of what has arrived at the bottom of light along `wo`, which is above the surface.
TransmissionLobe transmission_lobe(const Beam& arrived, const glm::dvec3& wo,
                                   const EnergyTables& tables);

// f, per steradian; `wi` below the surface.
glm::dvec3 transmission_value(const TransmissionLobe& lobe, const glm::dvec3& wi);

// Density of wi where transmission_sample chooses it; `wi` below the surface.
double transmission_pdf(const TransmissionLobe& lobe, const glm::dvec3& wi);

// May point above the surface: then it is none that the lobe has.
glm::dvec3 transmission_sample(const TransmissionLobe& lobe, const glm::dvec2& u);

}  // namespace lacquer::reference
