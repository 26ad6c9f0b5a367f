// Options that several commands share, and what they stand for.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "backends/backend.h"
#include "core/model.h"
#include "lacquer/material.h"

namespace CLI {
class App;
}

namespace lacquer {

// --material, --model, --backend, --device, --validation.
struct ShadingOptions {
    std::string material;
    std::string model = "plain";
    std::string backend = "reference";
    BackendOptions backend_options;
};

// Adds --device and --validation.
void add_device_options(CLI::App& command, BackendOptions& options);

// Adds all of them; --material is required.
void add_shading_options(CLI::App& command, ShadingOptions& options);

// What the options stand for. `open_shading` throws UsageError for names that do not exist, and
// Error where the material cannot be read or shaded, or the backend cannot run here.
struct Shading {
    Model model;
    Material material;
    std::unique_ptr<Backend> backend;
};

Shading open_shading(const ShadingOptions& options);

// Throws Error saying why the model cannot shade the material, where it cannot, and what can.
void require_model(const Material& material, Model model);

// Throws Error for a material with textures: only a picture of a surface says where to look.
void require_untextured(const Material& material);

// A direction given as its coordinates. Throws UsageError unless its length is 1 within
// kUnitTolerance: a direction that is not unit is a mistake, not something to mend silently.
glm::dvec3 unit_direction(std::string_view option, const std::vector<double>& coordinates);

inline constexpr double kUnitTolerance = 1e-5;

// Throws UsageError naming `option` and the range unless min <= value <= max; NaN is outside.
void require_range(std::string_view option, double value, double min, double max);

// Prints `text` on stdout. Throws Error where it cannot be written: a full disk is a failure.
void print_data(std::string_view text);

}  // namespace lacquer
