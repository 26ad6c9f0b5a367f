// Pieces of HTML and XML text.
#pragma once

#include <string>
#include <string_view>

namespace lacquer {

// `text` as character data or attribute value of HTML and XML; control characters, which XML
// forbids, become spaces.
std::string escaped(std::string_view text);

// The bytes of a PNG as an address that an <img> takes.
std::string png_data_uri(std::string_view png);

}  // namespace lacquer
