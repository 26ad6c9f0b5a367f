// A GGX lobe about the surface normal whatever the viewer, as light prefiltered with GGX kernels
// can be looked up with: facets reflect as seen along the normal, normalised.
// Based on: de Dinechin and Belcour 2022, Eq. 5
//
// L(wi) cos_theta_i = D(wm) G1(wi) / (4 N), wm halfway between wi and the normal, N such that the
// integral over wi is 1.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "reference/facets.h"
#include "tables/energy_tables.h"

namespace lacquer::reference {

struct NormalLobe {
    Facets facets;
    double energy;  // N, what the facets reflect of light along the normal
};

// The lobe that has this variance per axis of the projected disk; at least kMinAlpha rough.
NormalLobe prepare_normal_lobe(double variance, const EnergyTables& tables);

// L(wi), wi above the surface.
double normal_lobe(const NormalLobe& lobe, const glm::dvec3& wi);

// Density of normal_lobe_sample: D(wm) (1 + alpha^2) / 4 above the surface.
double normal_lobe_pdf(const NormalLobe& lobe, const glm::dvec3& wi);

// The normal mirrored by a facet, from u in [0, 1)^2. Facets that would mirror it below the surface
// are left out.
glm::dvec3 normal_lobe_sample(const NormalLobe& lobe, const glm::dvec2& u);

}  // namespace lacquer::reference
