#include "backends/node_packages.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/paths.h"

namespace lacquer {

namespace fs = std::filesystem;

fs::path runner_folder() {
    return share_folder() / "node" / "webgpu";
}

fs::path require_package_file(const fs::path& relative) {
    const fs::path file = runner_folder() / "node_modules" / relative;
    if (!fs::exists(file))
        throw Unavailable{fmt::format("'{}' is missing", file.string()),
                          fmt::format("npm ci --ignore-scripts --prefix '{}'",
                                      fs::weakly_canonical(runner_folder()).string())};
    return file;
}

}  // namespace lacquer
