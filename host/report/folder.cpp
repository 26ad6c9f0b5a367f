#include "report/folder.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/file.h"
#include "core/version.h"
#include "image/image_file.h"
#include "report/html.h"
#include "report/json.h"
#include "report/junit.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

// A name as one part of a path: materials may be given as paths themselves.
std::string file_part(const std::string& name) {
    std::string part = name.ends_with(".json") ? name.substr(0, name.size() - 5) : name;
    std::ranges::replace(part, '/', '_');
    return part;
}

Metadata metadata_of(const CompareResult& result, const std::string& material,
                     const std::string& backend, const QueryGrid& grid) {
    return {{"material", material},
            {"model", std::string{model_name(result.model)}},
            {"backend", backend},
            {"grid", grid.name},
            {"version", kVersion}};
}

// "slice 89.5" becomes "slice_89.5.exr".
std::string grid_file(const std::string& backend, const QueryGrid& grid) {
    std::string name = grid.name;
    for (char& c : name)
        if (c == ' ') c = '_';
    return fmt::format("{}_{}.exr", backend, name);
}

void write_pictures(const CompareResult& result, const fs::path& folder,
                    const std::string& material, const std::string& backend,
                    const std::vector<GridValues>& values, bool with_slices) {
    for (std::size_t g = 0; g < values.size(); ++g) {
        const QueryGrid& grid = result.grids[g];
        if (grid.kernel == Kernel::slice && !with_slices) continue;
        const std::vector<glm::dvec4> rows{values[g].rows.begin(), values[g].rows.end()};
        write_image(folder / grid_file(backend, grid), paint(grid, rows),
                    metadata_of(result, material, backend, grid));
    }
}

}  // namespace

void require_report_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure) throw Error{fmt::format("writing '{}': {}", folder.string(), failure.message())};
    require_writable(folder / "report.html");
}

void write_report(const CompareResult& result, const fs::path& folder) {
    require_report_folder(folder);
    write_file(folder / "compare.json", compare_json(result));
    write_file(folder / "junit.xml", compare_junit(result));
    write_file(folder / "report.html", report_html(result, current_environment()));
    for (std::size_t m = 0; m < result.materials.size(); ++m) {
        const std::string& material = result.materials[m].name;
        const fs::path pictures = folder / "exr" / file_part(material);
        fs::create_directories(pictures);
        write_pictures(result, pictures, material, "reference", result.reference_values[m], true);
        for (const BackendResult& backend : result.backends)
            if (!backend.materials.empty())
                write_pictures(result, pictures, material, backend.name,
                               backend.materials[m].values, !backend.materials[m].passed);
    }
}

}  // namespace lacquer
