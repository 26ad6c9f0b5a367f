// `lacquer albedo --method simulate`: the albedo by walks of light.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/simulate_options.h"
#include "lacquer/material.h"

namespace lacquer {

// Prints the albedo of a material for viewers at these cosines, each in [0, 1], from `samples`
// walks apiece, with standard errors. As JSON, light that one surface alone reflects is split by
// the number of facets it met.
void print_simulated_albedo(const Material& material, const std::vector<double>& cosines,
                            std::uint64_t samples, const SimulateOptions& options, bool json);

}  // namespace lacquer
