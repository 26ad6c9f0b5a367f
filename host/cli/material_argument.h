// Materials as they are named on the command line.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lacquer {

// The files of the bundled materials, sorted by name.
std::vector<std::filesystem::path> bundled_material_files();

// The file that `argument` means: a file's path, or the name of a bundled material ("gold"). Throws
// Error listing the bundled ones where there is neither; UsageError where it can only be a name.
std::filesystem::path material_file(const std::string& argument);

}  // namespace lacquer
