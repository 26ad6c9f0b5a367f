#include "cli/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "cli/material_argument.h"
#include "core/error.h"
#include "core/model_scope.h"

namespace lacquer {

void add_device_options(CLI::App& command, BackendOptions& options) {
    command.add_option("--device", options.device,
                       "Part of a Vulkan device's name, or its index (default: lavapipe)");
    command.add_flag("--validation", options.validation,
                     "Turn the Vulkan validation layers on; any message of theirs is an error");
}

void add_shading_options(CLI::App& command, ShadingOptions& options) {
    command.add_option("--material", options.material, "Material file, or a bundled name")
        ->required();
    command.add_option("--model", options.model, "How the material is shaded")
        ->capture_default_str();
    command.add_option("--backend", options.backend, "What evaluates it")->capture_default_str();
    add_device_options(command, options.backend_options);
}

Shading open_shading(const ShadingOptions& options) {
    const Model model = model_from_name(options.model);
    const BackendEntry& entry = backend_from_name(options.backend);
    Material material = load_material(material_file(options.material));
    require_model(material, model);
    return {model, std::move(material), entry.create(options.backend_options)};
}

void require_model(const Material& material, Model model) {
    const auto why = why_not_shadeable(material, model);
    if (!why) return;
    std::string able;
    for (const Model other : models_for(material))
        able += fmt::format("{}{}", able.empty() ? "" : ", ", model_name(other));
    throw Error{fmt::format("material '{}': {}; {}", material.name, *why,
                            able.empty() ? "no model can, only the simulator: `lacquer slice` and "
                                           "`lacquer albedo` with --method simulate"
                                         : "models that can: " + able)};
}

void require_untextured(const Material& material) {
    if (material.textures.empty()) return;
    throw Error{
        fmt::format("material '{}': {} is a texture, which only 'lacquer sphere' can look up",
                    material.name, material.textures.front().pointer)};
}

glm::dvec3 unit_direction(std::string_view option, const std::vector<double>& coordinates) {
    const glm::dvec3 w{coordinates.at(0), coordinates.at(1), coordinates.at(2)};
    const double length = glm::length(w);
    if (std::abs(length - 1.0) <= kUnitTolerance) return w;
    std::string message = fmt::format("{}: ({}, {}, {}) has length {:.6g}, must be 1 within {}",
                                      option, w.x, w.y, w.z, length, kUnitTolerance);
    if (std::isfinite(length) && length > 0.0)
        message += fmt::format("; in this direction that is {:.9g},{:.9g},{:.9g}", w.x / length,
                               w.y / length, w.z / length);
    throw UsageError{message};
}

void require_range(std::string_view option, double value, double min, double max) {
    if (value >= min && value <= max) return;
    throw UsageError{fmt::format("{}: {} is not in [{}, {}]", option, value, min, max)};
}

void print_data(std::string_view text) {
    const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
    if (written != text.size() || std::fflush(stdout) != 0)
        throw Error{"writing to the standard output failed"};
}

}  // namespace lacquer
