// OpenEXR files in memory.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "image/image.h"

namespace lacquer {

// String attributes of a picture, each written as "lacquer:KEY".
using Metadata = std::map<std::string, std::string>;

// The bytes of an EXR: 32-bit float R, G, B, A, zip compressed, attributes from `metadata`. Throws
// Error for an empty picture.
std::string encode_exr(const Image& image, const Metadata& metadata);

struct ExrPicture {
    Image image;
    Metadata metadata;  // the "lacquer:" attributes, without that prefix
};

// Reads R, G, B, A of any pixel type, or Y as grey; a missing alpha is 1. `origin` names the file
// in the Error for bytes that are no EXR, end too soon, or hold none of these channels.
ExrPicture decode_exr(std::string_view bytes, std::string_view origin);

}  // namespace lacquer
