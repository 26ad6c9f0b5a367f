// Colours for numbers: a perceptually uniform map, for pictures of errors.
#pragma once

#include "image/display.h"

namespace lacquer {

// The map "inferno" (Smith and van der Walt 2015, mpl colormaps): from black over violet and orange
// to pale yellow, lightness rising evenly. `unit` outside [0, 1] is clamped; NaN is
// kNotANumberColor, which the map does not contain.
DisplayColor heat_color(double unit);

}  // namespace lacquer
