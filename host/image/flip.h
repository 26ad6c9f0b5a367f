// How different two pictures look to someone who sees them alternate in the same place.
// Based on: Andersson et al. 2020, FLIP: A Difference Evaluator for Alternating Images
#pragma once

#include <span>
#include <vector>

#include "image/display.h"

namespace lacquer {

// Of the paper: a screen of 3840 pixels across 0.7 m, seen from 0.7 m.
inline constexpr double kPixelsPerDegree = 67.02;

// The difference per pixel, in [0, 1]: 0 where nothing is to be seen. Pictures of `width` pixels a
// row and equal size, as a display shows them; their alpha is not looked at.
std::vector<double> flip(std::span<const DisplayColor> reference,
                         std::span<const DisplayColor> test, int width,
                         double pixels_per_degree = kPixelsPerDegree);

}  // namespace lacquer
