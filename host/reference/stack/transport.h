// The light of a stack by adding up its orders: twice from interface to interface down to the base
// and up again, energy and shape of every lobe; then the rest in closed form, by the coefficients
// of the last pass (adding.h).
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, sections 4 and 5
//
// Unlike there, every coefficient of an interface or medium is averaged over the directions of the
// light that meets it, and the mean of what goes either way follows from the same average: light
// that is reflected at the critical angle stays beyond it.
#pragma once

#include "reference/stack/beam.h"
#include "reference/stack/layers.h"

namespace lacquer::reference {

struct StackLight {
    double top = 0.0;            // reflected by the top interface, all orders
    LobeLight interfaces, base;  // reflected below it at most, and by the base
    // At the bottom for the first time, where no conductor is: light that came straight down, and
    // light that was reflected on the way.
    Beam straight, detoured;

    // The base's lobe takes in that of the interfaces.
    void merge_lobes();

    Energy arrived() const { return straight.energy() + detoured.energy(); }
};

// Of light from the exterior at `cosine` in (0, 1].
StackLight light_from_above(const StackLayers& layers, double cosine);

// The same of light that has entered the top medium from there: per what entered, and nothing of it
// reflected by the top interface from above.
StackLight light_of_entered(const StackLayers& layers, double cosine);

// The fraction of diffuse light sent up from the bottom that comes back there, where no conductor
// is.
Energy diffuse_return(const StackLayers& layers);

}  // namespace lacquer::reference
