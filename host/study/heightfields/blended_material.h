// Surfaces whose facets change with height, and the uniform ones that are in them.
#pragma once

#include <string>
#include <vector>

#include "lacquer/material.h"

namespace lacquer::study {

// Isotropic facets for the share `weight` of a surface.
Stratum stratum(double weight, double alpha, Ndf ndf = Ndf::ggx);

// The strata from the top down.
Blend asymmetric(std::vector<Stratum> strata);

// The strata mixed at every height.
Blend symmetric(std::vector<Stratum> strata);

Material bare(std::string name, Base base);

// A conductor of index 1 + i kappa that along the normal reflects `color`, channels in [0, 1).
void set_metal(Stratum& stratum, const Rgb& color);

// One uniform surface of a blend, and its share of it.
struct UniformPart {
    Material material;
    double weight = 1.0;
};

// What a linear blend mixes: each kind of facet once. `blended` has one blended surface, its base
// or that of its first layer.
std::vector<UniformPart> uniform_parts(const Material& blended);

}  // namespace lacquer::study
