// The light that comes back through a rough coat from a Lambertian base below it, per channel.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces
//
// A path in eq. 3 enters (T01, directional), goes back and forth between base and coat, and leaves
// (T10_bar, diffuse, since the base forgets directions). `returned` holds what the last two make of
// light that has entered: rho T10_bar / (1 - rho R10_bar).
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/normal_lobe.h"
#include "tables/energy_tables.h"

namespace lacquer::reference {

// How the light that leaves is distributed.
enum class BaseLobe {
    exact,  // as it is: f = T01(wi) T01(wo) rho / (pi eta^2 (1 - rho R10_bar)). By reciprocity T01
            // is also the share of each direction in the light that leaves.
    ggx,    // as a GGX lobe about the normal, for prefiltered lighting; not reciprocal (eq. 5)
};

struct CoatedBase {
    BaseLobe shape;
    std::array<TransmissionProfile, 3> entering;  // T01 of each channel
    TransmissionProfile clear;                    // and of a clear medium, which bounds them
    glm::dvec3 returned;
    glm::dvec3 spread;  // of `exact`: rho / (pi eta^2 (1 - rho R10_bar))
    NormalLobe lobe;    // of `ggx`: the variance of its light, all channels and directions together
};

// `eta`: index of the coat over that of the exterior; `albedo` of the base and `tau` of the medium
// above it in [0, 1].
CoatedBase prepare_coated_base(const Roughness& roughness, double eta, const glm::dvec3& albedo,
                               const glm::dvec3& tau, BaseLobe shape, const EnergyTables& tables);

// All directions below are above the surface.

glm::dvec3 base_lobe(const CoatedBase& base, const glm::dvec3& wi, const glm::dvec3& wo);

// Density of base_sample, which does not depend on the viewer: 0 below the surface.
double base_pdf(const CoatedBase& base, const glm::dvec3& wi);

// A direction of light: cosine-weighted (exact) or from the lobe (ggx).
glm::dvec3 base_sample(const CoatedBase& base, const glm::dvec2& u);

// Directional albedo, eq. 3: T01(w) returned.
glm::dvec3 base_albedo(const CoatedBase& base, const glm::dvec3& w);

}  // namespace lacquer::reference
