// The baked tables as files for engines.
#pragma once

#include <filesystem>
#include <vector>

#include "codegen/codegen.h"

namespace lacquer::codegen {

// The packed texels in every format, from the table files in `folder`. Throws Error naming the one
// that is missing or damaged.
std::vector<TableFile> table_files(const std::filesystem::path& folder);

}  // namespace lacquer::codegen
