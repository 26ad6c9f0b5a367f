// Random rough surfaces, uniform and blended.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "lacquer/material.h"

namespace lacquer::test {

// Of `count` strata or, of 1, a uniform surface: alphas from `least_alpha` to 1, some anisotropic,
// either distribution, weights from 0.05 before they are normalised.
Roughness random_roughness(std::mt19937_64& generator, int count, double least_alpha);

// A bare conductor of random index; half of the blends have one for each stratum.
Material random_conductor(std::mt19937_64& generator, int strata, double least_alpha = 0.05);

// An interface without a base, of an index from 0.5 to 2.2 but at least 0.03 from 1.
Material random_dielectric(std::mt19937_64& generator, int strata, double least_alpha = 0.05);

// The same roughness on a conductor that reflects nearly all light.
Material mirrors(const Material& material);

// Operator, alphas, weights and indices.
std::string describe(const Material& material);

}  // namespace lacquer::test
