// Puts tidied definitions in the order of the source, each under its documentation.
#pragma once

#include <vector>

#include "codegen/declarations.h"
#include "codegen/text/tree.h"

namespace lacquer::codegen {

// A kernel: what it binds as translated, then its functions as `modules` declare them.
text::Statements arrange_kernel(text::Statements translated,
                                const std::vector<SourceModule>& modules, text::Dialect dialect);

// The library form: what `modules` declare and nothing else, with the comments that open their
// files, and the helpers of the translator that it needs.
text::Statements arrange_library(text::Statements translated,
                                 const std::vector<SourceModule>& modules, text::Dialect dialect);

}  // namespace lacquer::codegen
