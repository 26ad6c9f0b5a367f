// The baked tables as a file for engines.
#pragma once

#include <filesystem>

#include "codegen/codegen.h"

namespace lacquer::codegen {

// The packed texels, from the table files in `folder`. Throws Error naming the one that is missing
// or damaged.
TableFile table_file(const std::filesystem::path& folder);

}  // namespace lacquer::codegen
