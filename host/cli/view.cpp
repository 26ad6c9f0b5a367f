// `lacquer view`: a sphere in a window.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "cli/commands.h"
#include "cli/material_argument.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/file.h"
#include "core/model_scope.h"
#include "viewer/viewer.h"

namespace lacquer {

namespace {

constexpr int kMinSize = 64;
constexpr int kMaxSize = 4096;
constexpr int kMaxFrames = 1'000'000;
constexpr const char* kDefaultMaterial = "vermilion_lacquer";

constexpr const char* kSummary = "Show a sphere in a window, shaded by the generated SPIR-V";

constexpr const char* kHelp =
    "Drag with the mouse to move the highlight; choose a material with the arrow keys or 1 to 0,\n"
    "and with M the next model that can shade it; R turns the two lights behind the sphere on and\n"
    "off; Escape closes the window.\n\n"
    "Examples:\n"
    "  lacquer view --material gold\n"
    "  lacquer view --material celadon --model plain\n"
    "  lacquer view --material mine.json --device nvidia\n"
    "  xvfb-run lacquer view --material gold --screenshot gold.png";

struct Arguments {
    std::string material = kDefaultMaterial;
    std::optional<std::string> model;
    std::vector<double> light;
    BackendOptions device;
    viewer::Options options;
};

// All bundled materials that some model can shade, and before them the chosen one where it is none
// of these.
void load_materials(const std::string& argument, viewer::Options& options) {
    const std::filesystem::path chosen = material_file(argument);
    std::vector<std::filesystem::path> files = bundled_material_files();
    if (std::ranges::find(files, chosen) == files.end()) files.insert(files.begin(), chosen);
    for (const std::filesystem::path& file : files) {
        Material material = load_material(file);
        if (file == chosen)
            options.first_material = options.materials.size();
        else if (models_for(material).empty())
            continue;
        options.materials.push_back(std::move(material));
    }
}

void run(Arguments& arguments) {
    viewer::Options& options = arguments.options;
    if (!arguments.light.empty()) options.light = unit_direction("--light", arguments.light);
    options.device = arguments.device.device;
    options.validation = arguments.device.validation;
    if (!options.screenshot.empty()) {
        if (options.screenshot.extension() != ".png")
            throw UsageError{fmt::format("--screenshot {}: the extension is not .png",
                                         options.screenshot.string())};
        require_writable(options.screenshot);
    }
    load_materials(arguments.material, options);
    if (arguments.model) options.model = model_from_name(*arguments.model);
    const Material& first = options.materials[options.first_material];
    if (arguments.model || models_for(first).empty()) require_model(first, options.model);
    viewer::run(options);
}

}  // namespace

void add_view_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    viewer::Options& options = arguments->options;
    CLI::App* command = app.add_subcommand("view", kSummary)->footer(kHelp);
    command->add_option("--material", arguments->material, "Material file, or a bundled name")
        ->capture_default_str();
    command
        ->add_option("--model", arguments->model,
                     "How materials are shaded; those that it cannot shade by 'stack', 'plain' "
                     "or what else can")
        ->default_str(std::string{model_name(options.model)});
    add_device_options(*command, arguments->device);
    command
        ->add_option("--light", arguments->light,
                     "Unit direction X,Y,Z towards the only light; x points right, y up, z to "
                     "the viewer (default: a light to move, and two behind the sphere)")
        ->delimiter(',')
        ->expected(3);
    command->add_option("--size", options.size, "Pixels of either side of the window")
        ->check(CLI::Range(kMinSize, kMaxSize))
        ->capture_default_str();
    command->add_option("--frames", options.frames, "End after so many frames")
        ->check(CLI::Range(1, kMaxFrames));
    command->add_option("--screenshot", options.screenshot,
                        "Show no window, write its last frame to this PNG file and end");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
