// The materials of the suite.
#pragma once

#include <string>
#include <vector>

#include "lacquer/material.h"

namespace lacquer::study {

// A GGX interface above a medium of index `ior`, of transmittance `tau`.
Layer coat(double ior, double alpha, const Rgb& tau = {1.0, 1.0, 1.0});

// A medium between no interfaces: scattering of mean cosine `g`, 1 per unit of thickness.
Layer scattering_film(double thickness, double g);

// The same index in all channels.
ConductorBase grey_conductor(double eta, double kappa, double alpha);

// A metal of the bundled table.
ConductorBase metal(std::string_view name, double alpha);

Material stack_of(std::string name, std::vector<Layer> layers, Base base);

}  // namespace lacquer::study
