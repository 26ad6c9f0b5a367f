// A package to disk: everything is written aside and moved into place at the end.
#include <fmt/format.h>

#include "codegen/codegen.h"
#include "core/error.h"
#include "core/file.h"

namespace lacquer::codegen {

namespace fs = std::filesystem;

namespace {

// A folder beside the final files, which goes away with whatever is left in it.
class StagingFolder {
 public:
    explicit StagingFolder(const fs::path& folder) : path_{folder / ".lacquer-unfinished"} {
        fs::remove_all(path_);
        fs::create_directories(path_);
    }
    ~StagingFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    StagingFolder(const StagingFolder&) = delete;
    StagingFolder& operator=(const StagingFolder&) = delete;

    void add(const fs::path& relative, const std::string& contents) const {
        const fs::path file = path_ / relative;
        fs::create_directories(file.parent_path());
        write_file(file, contents);
    }

    void move_out(const fs::path& relative, const fs::path& folder) const {
        fs::rename(path_ / relative, folder / relative);
    }

 private:
    fs::path path_;
};

void write_files(const Package& package, const fs::path& folder) {
    const StagingFolder staging{folder};
    std::vector<fs::path> paths;
    const auto add = [&](const auto& files) {
        for (const auto& file : files) {
            staging.add(file.path, file.contents);
            paths.push_back(file.path);
        }
    };
    add(package.files);
    add(package.tables);
    staging.add("manifest.json", manifest(package));
    // What can fail comes before the first file is replaced.
    for (const fs::path& path : paths) fs::create_directories((folder / path).parent_path());
    for (const fs::path& path : paths) staging.move_out(path, folder);
    staging.move_out("manifest.json", folder);
}

// Folders from `folder` upwards that do not exist yet, the deepest first.
std::vector<fs::path> missing_folders(fs::path folder) {
    std::vector<fs::path> missing;
    std::error_code ignored;
    for (; !folder.empty() && !fs::exists(folder, ignored); folder = folder.parent_path())
        missing.push_back(folder);
    return missing;
}

}  // namespace

void write(const Package& package, const fs::path& folder) {
    const std::vector<fs::path> made = missing_folders(folder);
    const auto failure = [&](const std::string& reason) {
        std::error_code ignored;
        for (const fs::path& path : made) fs::remove(path, ignored);
        return Error{fmt::format("writing shaders to '{}': {}", folder.string(), reason)};
    };
    try {
        write_files(package, folder);
    } catch (const fs::filesystem_error& error) {
        throw failure(fmt::format("{}: {}", error.path1().string(), error.code().message()));
    } catch (const Error& error) {
        throw failure(error.what());
    }
}

}  // namespace lacquer::codegen
