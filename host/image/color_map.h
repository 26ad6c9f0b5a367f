// Colours for numbers: a perceptually uniform map, for pictures of errors and differences.
#pragma once

#include "image/display.h"

namespace lacquer {

// The map "inferno" (Smith and van der Walt 2015, mpl colormaps): from black over violet and orange
// to pale yellow, lightness rising evenly. `unit` outside [0, 1] is clamped; NaN is
// kNotANumberColor, which the map does not contain.
DisplayColor heat_color(double unit);

// A map for signed numbers: black at 0, over blue to white towards -1 and over orange to white
// towards 1. `unit` outside [-1, 1] is clamped; NaN is kNotANumberColor.
DisplayColor difference_color(double unit);

}  // namespace lacquer
