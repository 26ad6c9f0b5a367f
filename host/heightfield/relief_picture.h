// What a heightfield looks like: a shaded picture of it, and a cut through it.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "heightfield/heightfield.h"
#include "image/image.h"

namespace lacquer::heightfield {

struct ReliefView {
    int width = 480, height = 300;  // pixels
    double extent = 160.0;          // of the surface across the picture, in cells
};

// The surface seen at a slant, in parallel projection, lit from the left and by the sky; per
// stratum its colour.
Image relief_picture(const Heightfield& surface, std::span<const Rgb> colors,
                     const ReliefView& view);

// Heights along +x through the middle of the tile, at `points` places over `extent` cells.
std::vector<glm::dvec2> relief_profile(const Heightfield& surface, double extent, int points);

}  // namespace lacquer::heightfield
