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
        const fs::path target = folder / relative;
        fs::create_directories(target.parent_path());
        fs::rename(path_ / relative, target);
    }

 private:
    fs::path path_;
};

void write_files(const Package& package, const fs::path& folder) {
    const StagingFolder staging{folder};
    for (const ShaderFile& file : package.files) staging.add(file.path, file.contents);
    staging.add("manifest.json", manifest(package));
    for (const ShaderFile& file : package.files) staging.move_out(file.path, folder);
    staging.move_out("manifest.json", folder);
}

}  // namespace

void write(const Package& package, const fs::path& folder) {
    std::error_code ignored;
    const bool existed = fs::exists(folder, ignored);
    const auto failure = [&](const std::string& reason) {
        if (!existed) fs::remove(folder, ignored);
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
