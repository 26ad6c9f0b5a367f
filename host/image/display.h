// From linear radiance to what a display shows: the same transform as
// shader_src/lighting/tone_mapping.glsl, written independently.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "image/image.h"

namespace lacquer {

// Radiance in [0, infinity) to [0, 1): 1 - exp(-x). Negative radiance counts as none.
double tone_curve(double radiance);

// IEC 61966-2-1 (sRGB) transfer function from linear [0, 1] to encoded [0, 1], and back.
double srgb_encode(double linear);
double srgb_decode(double encoded);

// One colour of a display, channels and straight alpha in [0, 255].
struct DisplayColor {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;
    bool operator==(const DisplayColor&) const = default;
};

// Tone curve, then sRGB encoding, rounded to the nearest of 256 levels. What is not a number
// becomes kNotANumberColor, so that it is seen.
DisplayColor display_color(const glm::vec4& premultiplied);

inline constexpr DisplayColor kNotANumberColor{255, 0, 255, 255};

// All pixels of `image` as a display shows them.
std::vector<DisplayColor> display_pixels(const Image& image);

}  // namespace lacquer
