// One material's rough surface as a figure: the surface itself, and where it sends light, by ray
// traced heightfields beside Smith's theory.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields, figure 13
#pragma once

#include "heightfield/material_light.h"
#include "study/figure.h"
#include "study/suite.h"

namespace lacquer::study {

// What the page of a surface says of itself. Its figures are made one by one.
inline constexpr Suite kHeightfieldSuite{
    "heightfield",
    "Rough surfaces, traced",
    "After section 4 of d'Eon, Bitterli, Weidlich and Zeltner 2023, Microfacet Theory for "
    "Non-Uniform Heightfields",
    "The light is that on explicit surfaces; Smith's theory, by which all else here is simulated, "
    "takes neighbouring facets as independent.",
    {},
    "Heightfields are Gaussian with a Gaussian autocorrelation, periodic, stretched stratum by "
    "stratum; rays meet their facets in double precision until they leave. Errors of the "
    "heightfields' numbers are those between surfaces."};

// Pictures are pi f cos_theta_o over the hemisphere of outgoing directions: for light that comes
// from the right.
Figure surface_figure(const heightfield::MaterialLight& light);

}  // namespace lacquer::study
