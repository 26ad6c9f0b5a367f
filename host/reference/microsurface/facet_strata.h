// Facets of several populations on one rough surface, mixed at every height or one above the other,
// and how much of each can be seen.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields
//
// Height is measured by C(h), the fraction of the surface below h: a population has as much of the
// surface as it has of C. Directions are above the surface.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "lacquer/material.h"
#include "reference/facets.h"

namespace lacquer::reference {

struct FacetStratum {
    double weight = 1.0;  // of the surface's area; all strata together 1
    Facets facets;
};

struct FacetStrata {
    Blend::Operator op = Blend::Operator::asymmetric;
    std::vector<FacetStratum> strata;  // at least one, from the top down
};

// The same surface seen from below.
FacetStrata turned_over(FacetStrata surface);

// D(wm) of the whole surface, per solid angle: linear in the weights. Eq. 6.
double density(const FacetStrata& surface, const glm::dvec3& wm);

// Lambda(w) of a symmetric blend, linear in the weights. Eq. 8.
double lambda(const FacetStrata& surface, const glm::dvec3& w);

// sigma(w) of a symmetric blend, the area of facets facing away from w per unit of macroscopic
// area, linear in the weights: cos_theta (1 + Lambda). Eq. 9.
double projected_area(const FacetStrata& surface, const glm::dvec3& w);

// Shares of the surface, one per stratum. Since facets see their surroundings whichever way they
// face, D of a stratum times its share of what is visible is the density of its visible normals.
using StratumShares = std::vector<double>;

// Visible from w: G1(w) divided among the strata.
StratumShares masking(const FacetStrata& surface, const glm::dvec3& w);

// The part of light along w that meets its first facet in each stratum, however the facets tilt:
// together 1. What is visible of the facets times their projected area, over cos_theta.
StratumShares first_met(const FacetStrata& surface, const glm::dvec3& w);

// Visible from wi and from wo: G2 divided among the strata. Eqs. 13 to 19, of any number of strata.
StratumShares masking_shadowing(const FacetStrata& surface, const glm::dvec3& wi,
                                const glm::dvec3& wo);

// Visible from `above` on one side of their facet and from `below`, mirrored to above the surface,
// on the other: P_top, P_bot of Eq. 20, of any number of strata.
StratumShares masking_through(const FacetStrata& surface, const glm::dvec3& above,
                              const glm::dvec3& below);

}  // namespace lacquer::reference
