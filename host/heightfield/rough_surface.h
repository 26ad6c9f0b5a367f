// The one rough surface of a material, for both ways to light it: Smith's theory and heightfields.
#pragma once

#include <span>
#include <vector>

#include "lacquer/material.h"
#include "simulator/microsurface.h"

namespace lacquer::heightfield {

struct RoughSurface {
    simulator::SurfaceWalk walk;
    std::vector<simulator::FacetStratum> strata;  // from the top down
};

// Throws Error naming the material and the JSON pointer where the material is not one rough surface
// alone (a bare conductor or diffuse facets, or one interface over nothing), or not one that a
// stretched Gaussian heightfield has: Beckmann facets, strata one upon the other, their alphas in
// one ratio.
RoughSurface rough_surface(const Material& material);

// The same of strata alone: throws Error naming the stratum.
void require_stretchable(std::span<const simulator::FacetStratum> strata);

}  // namespace lacquer::heightfield
