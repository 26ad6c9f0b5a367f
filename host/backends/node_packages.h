// Files of the npm packages beside the WebGPU runner (host/backends/webgpu).
#pragma once

#include <filesystem>

namespace lacquer {

// The folder of the runner and its node_modules. Throws Error where the share folder is missing.
std::filesystem::path runner_folder();

// A file below node_modules. Throws Unavailable, with the npm command that brings it, where it is
// missing.
std::filesystem::path require_package_file(const std::filesystem::path& relative);

}  // namespace lacquer
