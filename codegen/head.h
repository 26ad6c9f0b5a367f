// The comment that opens every generated text.
#pragma once

#include <string>

#include "codegen/codegen.h"
#include "codegen/variants.h"

namespace lacquer::codegen {

// What the file is, its licence, what was chosen, and the hash of the source that it was made from.
std::string file_head(const ShaderFile& file, const Level& level, const StackChoices& stacks,
                      const std::string& source_sha256);

}  // namespace lacquer::codegen
