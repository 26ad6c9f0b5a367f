// Where the program finds what it ships with, from whichever folder it is started.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lacquer {

// The folder that holds shaders/, materials/, tables/ and node/: $LACQUER_SHARE where set, else
// ../share/lacquer beside the running program's folder. Throws Error where neither exists.
std::filesystem::path share_folder();

// A file below share_folder(); throws Error naming it where it is missing.
std::filesystem::path share_file(const std::filesystem::path& relative);

// The folder of modules that are loaded at run time, beside the running program's folder.
std::filesystem::path module_folder();

// A Node.js of at least kMinNodeMajor: $LACQUER_NODE alone where set, else the one found when the
// project was configured or the one on the PATH; nothing where there is none new enough.
std::optional<std::filesystem::path> node_program();

// Why node_program() found nothing, and what to do about it.
std::string node_missing_message();

inline constexpr int kMinNodeMajor = 20;

}  // namespace lacquer
