// PNG files in memory (libpng).
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/display.h"
#include "image/image.h"

namespace lacquer {

// The bytes of a PNG of 8-bit RGBA pixels, rows from the top. Throws Error where width * height is
// not the number of pixels, or is none.
std::string encode_png(int width, int height, std::span<const DisplayColor> pixels);

// The same from indices into a palette of at most 256 colours: smaller, for maps of few levels.
std::string encode_png(int width, int height, std::span<const std::uint8_t> indices,
                       std::span<const DisplayColor> palette);

// Reads a PNG of any kind at 8 bits per channel. Values are encoded level / 255 as they stand in
// the file, alpha straight: a caller that means light decodes them with srgb_decode. `origin` names
// the file in the Error for bytes that are no PNG or end too soon.
Image decode_png(std::string_view bytes, std::string_view origin);

}  // namespace lacquer
