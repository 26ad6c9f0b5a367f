// The light that a rough dielectric coat reflects without letting it in: once by its facets, and
// diffusely what meets more than one, so that none is lost.
// Based on: Kulla and Conty 2017, Revisiting Physically Based Shading at Imageworks (the diffuse
//           part); Walter et al. 2007, Microfacet Models for Refraction through Rough Surfaces
//
// f = F D G2 / (4 cos_theta_i cos_theta_o) + m(wi) m(wo) / (pi m_average)
//
// with m(w) the part of the directional albedo that has met more than one facet.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lacquer/material.h"
#include "reference/microsurface/single_scattering.h"
#include "tables/energy_tables.h"

namespace lacquer::reference {

// Of m, averaged over cosine-weighted directions. Below it the ripple of the tables' polynomials
// would be seen as rings, and light that met several facets fades out.
inline constexpr double kLeastMultipleAverage = 1e-3;

struct Coat {
    RoughSide side;                // as it is shaded: at least kMinAlpha rough
    double eta;                    // index below over index of the exterior
    TransmissionProfile entering;  // what the coat does not reflect
    DirectionPolynomial multiple;  // m where it is in [0, 1]
    double multiple_scale;         // of m(wi) m(wo), an f whose albedo is m
};

// Throws Error where eta is outside the tables' range.
Coat prepare_coat(const Roughness& roughness, double eta, const EnergyTables& tables);

// Densities of directions where wo is mirrored by a visible normal, and such a direction, from u in
// [0, 1)^3 as visible_normals.h takes it; below the horizon as well.
double coat_mirrored_pdf(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo);
glm::dvec3 coat_mirrored(const Coat& coat, const glm::dvec3& wo, const glm::dvec3& u);

// All directions below are above the surface.

double coat_lobe(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo);

// Density with which coat_sample chooses wi; below the horizon as well.
double coat_pdf(const Coat& coat, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for wo: with probability single_share, decided by `choice` in [0, 1), wo
// mirrored by a visible normal, which may point below the surface; else a cosine-weighted one.
glm::dvec3 coat_sample(const Coat& coat, const glm::dvec3& wo, double choice, const glm::dvec2& u);

// 1 - m / albedo at wo, at least kMinChoice; 1 where the coat reflects nothing.
double single_share(const Coat& coat, const glm::dvec3& wo);

// Directional albedo, all orders of scattering: by definition that of the tables. The integral of
// coat_lobe is 0.005 off in the mean over isotropic GGX facets, for eta > 1 at most 0.02; for eta <
// 1 at grazing angles (cos_theta 0.05) as much as 0.07 less at alpha 0.03, where the table of m is
// coarse, and 0.04 more at eta 0.99.
double coat_albedo(const Coat& coat, const glm::dvec3& w);

}  // namespace lacquer::reference
