// Numbers of a material as shaders take them.
#pragma once

#include "lacquer/material.h"

namespace lacquer {

// Of absorption, along the normal; infinite where a medium is opaque.
Rgb optical_depth(const Medium& medium);

// An index over the exterior's.
Rgb relative_index(Rgb index, double exterior_ior);

}  // namespace lacquer
