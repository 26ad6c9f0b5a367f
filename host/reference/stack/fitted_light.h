// The light of a stack as cubics of the cosine at which it came: of light that has entered,
// energies and widths change little with direction. A direction then costs no transport.
#pragma once

#include <array>

#include "reference/facets.h"
#include "reference/stack/cubic.h"
#include "reference/stack/layers.h"
#include "reference/stack/transport.h"

namespace lacquer::reference {

// What becomes of light that has entered at each of the nodes of cubics from `least` on: as far
// from the cosine of the top interface's critical angle as its facets tilt, beyond which hardly any
// light enters a thinner medium.
struct EnteredLight {
    double least = 0.0;
    std::array<StackLight, kCubicNodes> known;
};

EnteredLight entered_light(const StackLayers& layers);

// Facets that make a lobe of this width, as it is shaded.
Facets facets_of(const LobeLight& light);

struct FittedLobe {
    Cubic<Energy> energy;                  // per what has entered, where the cubic is in [0, 1]
    Cubic<double> alpha;                   // of the lobe's width (lobe_width.h)
    double narrowest = 0.0, widest = 0.0;  // of the known alphas, which bound all others

    bool is_dark() const;
    LobeLight at(double cosine) const;
};

// Of the lights at the nodes of cubics from `least` on. Where there is none, alpha is that of the
// next node that has some.
FittedLobe fit_lobe(const std::array<LobeLight, kCubicNodes>& known, double least);

// A lobe with a mean direction of its own.
struct FittedBeam {
    FittedLobe lobe;
    Cubic<double> sine_ratio;  // of the mean's sine to that of the light that came

    Beam at(double cosine) const;
};

FittedBeam fit_beam(const std::array<Beam, kCubicNodes>& known, double least);

}  // namespace lacquer::reference
