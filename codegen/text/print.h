// Statements back to text: four spaces, braces on the line that opens them, at most 100 columns.
#pragma once

#include <string>

#include "codegen/text/tree.h"

namespace lacquer::codegen::text {

inline constexpr std::size_t kColumns = 100;

std::string print(const Statements& statements);

}  // namespace lacquer::codegen::text
