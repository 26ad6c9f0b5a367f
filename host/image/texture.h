// Numbers looked up in a picture.
#pragma once

#include <glm/vec2.hpp>

#include "image/image.h"

namespace lacquer {

// Channel `channel` (one of r, g, b, a) of `image` at `uv`, interpolated linearly between pixel
// centres. u runs right and repeats; v runs up from the lower edge and is clamped.
double sample_texture(const Image& image, char channel, const glm::dvec2& uv);

}  // namespace lacquer
