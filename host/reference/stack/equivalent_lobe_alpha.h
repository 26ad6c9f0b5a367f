// Which GGX roughness makes lobes as wide as those of another microsurface, so that the lobes of a
// stack of different ones add up: what Belcour 2018, appendix A, leaves open, whose space holds one
// distribution.
//
// The width is the standard deviation on the projected disk, of which the tails of GGX have most
// where alpha is small: a Beckmann lobe is as wide as one of GGX of 0.4 to 0.6 times its roughness.
// That ratio depends on the angle too (along the normal 0.4 to above 1, at a cosine of 0.2 0.4 to
// 0.2); one for all angles was fitted to the widths of simulated stacks (the figure `beckmann` of
// the suite `layered`).
#pragma once

#include "lacquer/material.h"

namespace lacquer::reference {

// In [0, 1]; of GGX its own roughness, of an anisotropic one the mean of both.
double equivalent_lobe_alpha(const Microsurface& microsurface);

}  // namespace lacquer::reference
