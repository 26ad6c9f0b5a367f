#include "cli/material_argument.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.h"
#include "core/paths.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

bool looks_like_path(const std::string& argument) {
    return argument.find_first_of("./") != std::string::npos;
}

}  // namespace

std::vector<fs::path> bundled_material_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator{share_file("materials")})
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

fs::path material_file(const std::string& argument) {
    // A folder that happens to be called like a bundled material does not hide it.
    if (looks_like_path(argument) ? fs::exists(argument) : fs::is_regular_file(argument))
        return argument;
    std::vector<std::string> names;
    for (const fs::path& file : bundled_material_files()) {
        if (file.stem() == argument) return file;
        names.push_back(file.stem().string());
    }
    const std::string message =
        fmt::format("'{}' is neither a file nor a bundled material; there are: {}", argument,
                    fmt::join(names, ", "));
    if (looks_like_path(argument)) throw Error{message};
    throw UsageError{message};
}

}  // namespace lacquer
