#include "core/paths.h"

#include <fmt/format.h>

#include <boost/process/search_path.hpp>
#include <cstdlib>
#include <vector>

#include "core/environment.h"
#include "core/error.h"
#include "core/process.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

// Major version of the Node.js at `program`; 0 where it does not answer.
int node_major(const fs::path& program) {
    try {
        const ProcessResult result = run_process(program, {"--version"});
        if (result.exit_code != 0 || result.out.size() < 2 || result.out[0] != 'v') return 0;
        return std::atoi(result.out.c_str() + 1);
    } catch (const Error&) {
        return 0;
    }
}

std::optional<fs::path> find_node() {
    std::vector<fs::path> candidates;
    if (const auto chosen = environment_variable("LACQUER_NODE")) {
        candidates.emplace_back(*chosen);
    } else {
        if (const fs::path configured{LACQUER_CONFIGURED_NODE}; !configured.empty())
            candidates.push_back(configured);
        if (const auto found = boost::process::search_path("node"); !found.empty())
            candidates.emplace_back(found.string());
    }
    for (const fs::path& candidate : candidates)
        if (node_major(candidate) >= kMinNodeMajor) return candidate;
    return std::nullopt;
}

// Where bin/ and share/ stand.
fs::path prefix_folder() {
    return fs::read_symlink("/proc/self/exe").parent_path().parent_path();
}

}  // namespace

fs::path share_folder() {
    if (const auto chosen = environment_variable("LACQUER_SHARE")) {
        if (!fs::is_directory(*chosen))
            throw Error{fmt::format("LACQUER_SHARE is '{}', which is not a folder", *chosen)};
        return *chosen;
    }
    const fs::path folder = prefix_folder() / "share" / "lacquer";
    if (!fs::is_directory(folder))
        throw Error{
            fmt::format("the folder '{}' is missing: set LACQUER_SHARE to where shaders/, "
                        "materials/ and tables/ are",
                        folder.string())};
    return folder;
}

fs::path share_file(const fs::path& relative) {
    const fs::path file = share_folder() / relative;
    if (!fs::exists(file)) throw Error{fmt::format("the file '{}' is missing", file.string())};
    return file;
}

fs::path module_folder() {
    return prefix_folder() / LACQUER_MODULE_FOLDER;
}

std::optional<fs::path> node_program() {
    static const std::optional<fs::path> found = find_node();
    return found;
}

std::string node_missing_message() {
    return fmt::format(
        "Node.js {} or newer was not found: install it, or set LACQUER_NODE to its path",
        kMinNodeMajor);
}

}  // namespace lacquer
