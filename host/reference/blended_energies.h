// The energies of a rough interface of several strata from those of interfaces that are uniformly
// like each: by the part of the light that meets its first facet there, as if all facets met after
// it were alike. Light that goes on from there to another stratum is off by the difference of two
// reflectances. Against simulation (tests/statistical/blend_simulation_test.cpp), random blends of
// two or three strata, one above the other or mixed: albedos of coats 0.0022 off in the mean, of
// stacks of one to three over Lambertian bases 0.0034 to 0.0068, over blended conductors 0.0054 to
// 0.0066; at most 0.088, at grazing angles. In no paper.
#pragma once

#include <functional>
#include <vector>

#include "lacquer/material.h"
#include "reference/microsurface/facet_strata.h"
#include "tables/polynomial.h"

namespace lacquer::reference {

// A uniform surface is one stratum.
Blend strata_of(const Roughness& roughness);

// Isotropic GGX facets of these roughnesses, a stratum's each, in place of a blend's own: which
// strata light meets first is asked of them, as energies are (equivalent_alpha.h).
FacetStrata isotropic_strata(const Blend& blend, const std::vector<double>& alphas);

// The parts of light at `cosine` in [0, 1] from above that meet the strata first; next to grazing
// those of kLeastCosine.
StratumShares first_met_at(const FacetStrata& surface, double cosine);

// The same of light from below, which meets the lowest stratum first.
StratumShares first_met_from_below(const FacetStrata& surface, double cosine);

// A function of the stratum and of the cosine in [0, 1].
using OfStratum = std::function<double(std::size_t k, double cosine)>;

// One function of direction in place of those of the strata, with the critical cosine of all of
// them (tables/polynomial.h): the polynomial through their sum at Chebyshev's nodes to each side.
DirectionPolynomial blended(const FacetStrata& surface, double critical, const OfStratum& value);

// Of one stratum its own.
DirectionPolynomial blended(const FacetStrata& surface,
                            const std::vector<DirectionPolynomial>& of_strata);

// Of diffuse light from below, the parts that meet the strata first.
StratumShares first_met_by_diffuse_light(const FacetStrata& surface);

}  // namespace lacquer::reference
