// The materials of the suite.
#pragma once

#include <string>

#include "lacquer/material.h"

namespace lacquer::study {

inline constexpr Rgb kClear{1.0, 1.0, 1.0}, kWhite{1.0, 1.0, 1.0};

// One GGX coat of index `eta` over the exterior's, over a medium and a Lambertian base. Its name
// says eta and alpha, and tau where it is not clear.
Material coated(double eta, double alpha, const Rgb& albedo, const Rgb& tau = kClear);

}  // namespace lacquer::study
