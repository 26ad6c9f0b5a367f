#include "backends/shader_store.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file.h"
#include "core/paths.h"

namespace lacquer {

namespace fs = std::filesystem;

namespace {

nlohmann::json load_manifest(const fs::path& file) {
    try {
        return nlohmann::json::parse(read_file(file));
    } catch (const nlohmann::json::exception& error) {
        throw Error{fmt::format("'{}': {}", file.string(), error.what())};
    }
}

bool is_kernel(const nlohmann::json& entry, std::string_view target, Model model, Kernel kernel) {
    return entry.at("target") == target && entry.at("form") == "kernel" &&
           entry.at("level") == kernel_level(model, kernel) &&
           entry.at("kernel") == kernel_shape(kernel).name;
}

}  // namespace

std::string_view kernel_level(Model model, Kernel kernel) {
    return model_level(shades_materials(kernel) ? model : all_models().front());
}

ShaderSource load_shader(std::string_view target, Model model, Kernel kernel) {
    const fs::path manifest_file = share_file("shaders/manifest.json");
    const nlohmann::json manifest = load_manifest(manifest_file);
    try {
        for (const nlohmann::json& entry : manifest.at("files")) {
            if (!is_kernel(entry, target, model, kernel)) continue;
            const fs::path file = share_file(fs::path{"shaders"} / entry.at("path"));
            return {file, read_file(file), entry.at("entry_points").at(0).at("name")};
        }
    } catch (const nlohmann::json::exception& error) {
        throw Error{fmt::format("'{}': {}", manifest_file.string(), error.what())};
    }
    throw Error{fmt::format("'{}' lists no {} kernel '{}' of level '{}'", manifest_file.string(),
                            target, kernel_shape(kernel).name, kernel_level(model, kernel))};
}

}  // namespace lacquer
