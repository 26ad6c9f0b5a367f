// Light that goes back and forth in a stack for ever, from what each of its interfaces reflects and
// lets through: geometric series of series.
// Based on: Belcour 2018, Efficient Rendering of Layered Materials using an Atomic Decomposition
//           with Statistical Operators, Eqs. 28-31
#pragma once

#include <vector>

#include "reference/stack/beam.h"

namespace lacquer::reference {

// Of light on its way down or up to interface n, after crossing the medium it comes from.
struct InterfaceShares {
    Energy reflected_down{0.0}, transmitted_down{0.0};  // of light going down
    Energy reflected_up{0.0}, transmitted_up{0.0};      // of light going up
};

// By medium, 0 being the exterior: of light about to cross it downwards...
struct StackShares {
    std::vector<Energy> escaping;  // what leaves at the top in the end
    std::vector<Energy> arriving;  // what reaches the bottom for the first time
    Energy returning{0.0};         // of light about to go up from the bottom: what comes back there
};

// `base` is what the base sends back, or lets arrive, of light about to cross the medium above it;
// it arrives where `base_reflects` is false.
StackShares add_up(const std::vector<InterfaceShares>& interfaces, const Energy& base,
                   bool base_reflects);

}  // namespace lacquer::reference
