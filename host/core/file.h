// Files read and written whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace lacquer {

// All bytes of `file`. Throws Error naming it where it cannot be read.
std::string read_file(const std::filesystem::path& file);

// Writes `contents` to `file`, which appears whole or stays as it was: the bytes go to a file
// beside it that takes its place at the end. Devices and pipes are written to directly. Throws
// Error naming the file where that fails.
void write_file(const std::filesystem::path& file, std::string_view contents);

// Throws Error where write_file(file, ...) could not succeed, so that a long computation fails
// before it starts.
void require_writable(const std::filesystem::path& file);

}  // namespace lacquer
