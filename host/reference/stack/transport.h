// The light of a stack by adding up its orders: from interface to interface down to the base and up
// again, energy and shape of every lobe, until what is left is small; the rest is a geometric
// series. Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic
// Decomposition
//           with Statistical Operators, sections 4 and 5
//
// Unlike there, every coefficient of an interface or medium is averaged over the directions of the
// light that meets it, and the mean of what goes either way follows from the same average: light
// that is reflected at the critical angle stays beyond it. Orders are added up one after the other,
// since each is wider than the one before.
#pragma once

#include <vector>

#include "reference/stack/beam.h"
#include "reference/stack/layers.h"

namespace lacquer::reference {

struct StackLight {
    // What leaves upwards, by its deepest reflection: interfaces from the top, then the base. All
    // of it leaves about the mirror direction of the light that came.
    std::vector<LobeLight> lobes;
    Energy down{0.0};  // arrives at the bottom for the first time, where no conductor is
};

// Of light from the exterior at cos_theta in (0, 1].
StackLight light_from_above(const StackLayers& layers, double cos_theta);

// The fraction of diffuse light sent up from the bottom that comes back there, where no conductor
// is.
Energy diffuse_return(const StackLayers& layers);

}  // namespace lacquer::reference
