// A package to disk: everything is written aside and moved into place at the end.
#include <fmt/format.h>

#include <fstream>

#include "codegen/codegen.h"
#include "core/error.h"

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
        std::ofstream stream{file, std::ios::binary};
        stream << contents;
        stream.close();
        if (!stream) throw Error{fmt::format("writing '{}' failed", file.string())};
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
    const bool existed = fs::exists(folder);
    try {
        write_files(package, folder);
    } catch (const std::exception& error) {
        std::error_code ignored;
        if (!existed) fs::remove(folder, ignored);
        throw Error{fmt::format("writing shaders to '{}': {}", folder.string(), error.what())};
    }
}

}  // namespace lacquer::codegen
