// `lacquer slice`: a picture of the BSDF over all light directions, for one viewer.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <memory>
#include <numbers>

#include "cli/commands.h"
#include "cli/material_argument.h"
#include "cli/options.h"
#include "cli/picture.h"
#include "cli/simulated_slice.h"
#include "compare/grids.h"
#include "core/error.h"
#include "image/image_file.h"

namespace lacquer {

namespace {

constexpr double kMaxTheta_deg = 90.0;

// Walks of a simulation.
constexpr std::int64_t kDefaultWalks = 20'000'000;

constexpr const char* kSummary = "Draw the BSDF over all light directions for one viewer";

constexpr const char* kHelp =
    R"(Draws the BSDF over the hemisphere of light directions for one viewer, in Lambert's azimuthal
equal-area projection: the normal is the centre, the horizon the edge, x points right, y up.
An EXR holds the BSDF per steradian in linear RGB, alpha 1 where there is a direction. A PNG
shows pi times that through the tone curve 1 - exp(-x), encoded for a display. Ctrl-C ends a
simulation and writes what it found so far; the EXR's attributes say how exact that is.

Examples:
  lacquer slice --material gold --wo-theta 60 -o gold.exr
  lacquer slice --material gold --wo 0,0.6,0.8 --size 1024 -o gold.png
  lacquer slice --material gold --method simulate --size 256 -o gold.exr)";

struct Arguments {
    ShadingOptions shading;
    PictureOptions picture;
    SimulateOptions simulate;
    std::string method = model_method().name;
    double wo_theta_deg = 45.0;
    std::vector<double> wo;
};

glm::dvec3 viewer(const Arguments& arguments) {
    if (!arguments.wo.empty()) {
        const glm::dvec3 wo = unit_direction("--wo", arguments.wo);
        require_range("--wo z, the cosine to the normal", std::min(wo.z, 1.0), 0.0, 1.0);
        return wo;
    }
    require_range("--wo-theta", arguments.wo_theta_deg, 0.0, kMaxTheta_deg);
    return direction_at(arguments.wo_theta_deg);
}

// Writes f, or pi f where the file is for looking at.
void write_slice(const std::filesystem::path& output, Image image, const Metadata& metadata) {
    if (is_display_format(output))
        for (glm::vec4& pixel : image.pixels)
            pixel = glm::vec4{std::numbers::pi_v<float> * glm::vec3{pixel}, pixel.w};
    write_image(output, image, metadata);
}

void simulate(const Arguments& arguments, const glm::dvec3& wo) {
    const std::uint64_t walks = walk_count(arguments.simulate, kDefaultWalks);
    const Material material = load_material(material_file(arguments.shading.material));
    require_untextured(material);
    const SimulatedSlice slice =
        simulate_slice(material, wo, arguments.picture.size, walks, arguments.simulate);
    write_slice(arguments.picture.output, slice.image, slice.metadata);
}

void run(const CLI::App& command, const Arguments& arguments) {
    const glm::dvec3 wo = viewer(arguments);
    require_image_output(arguments.picture.output);
    require_method(
        command, arguments.method,
        std::array{model_method(), Method{kSimulateMethod, {"--samples", "--seed", "--orders"}}});
    if (arguments.method == kSimulateMethod) return simulate(arguments, wo);
    const Shading shading = open_shading(arguments.shading);
    require_untextured(shading.material);
    const QueryGrid grid = slice_grid("slice", wo, arguments.picture.size);
    Job job;
    job.model = shading.model;
    job.kernel = grid.kernel;
    job.materials = {&shading.material, 1};
    job.queries_per_material = grid.query_count();
    job.inputs = grid.inputs;
    job.parameters = grid.parameters;
    write_slice(arguments.picture.output, paint(grid, shading.backend->run(job).rows),
                picture_metadata(arguments.shading, shading));
}

}  // namespace

void add_slice_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("slice", kSummary)->footer(kHelp);
    add_shading_options(*command, arguments->shading);
    add_picture_options(*command, arguments->picture);
    CLI::Option* theta =
        command
            ->add_option("--wo-theta", arguments->wo_theta_deg,
                         "Degrees from the normal to the viewer, towards +x, 0 to 90")
            ->capture_default_str();
    command->add_option("--wo", arguments->wo, "Unit direction X,Y,Z to the viewer, Z not negative")
        ->delimiter(',')
        ->expected(3)
        ->excludes(theta);
    command->add_option("--method", arguments->method, "How: model or simulate")
        ->capture_default_str();
    add_walk_options(*command, arguments->simulate,
                     "Walks of a simulation, all pixels together (default 20000000)");
    add_orders_option(*command, arguments->simulate);
    command->callback([command, arguments] { run(*command, *arguments); });
}

}  // namespace lacquer
