// `lacquer slice`: a picture of the BSDF over all light directions, for one viewer.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <numbers>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/picture.h"
#include "compare/grids.h"
#include "core/error.h"
#include "image/image_file.h"

namespace lacquer {

namespace {

constexpr double kMaxTheta_deg = 90.0;

constexpr const char* kSummary = "Draw the BSDF over all light directions for one viewer";

constexpr const char* kHelp =
    R"(Draws the BSDF over the hemisphere of light directions for one viewer, in Lambert's azimuthal
equal-area projection: the normal is the centre, the horizon the edge, x points right, y up.
An EXR holds the BSDF per steradian in linear RGB, alpha 1 where there is a direction. A PNG
shows pi times that through the tone curve 1 - exp(-x), encoded for a display.

Examples:
  lacquer slice --material gold --wo-theta 60 -o gold.exr
  lacquer slice --material gold --wo 0,0.6,0.8 --size 1024 -o gold.png)";

struct Arguments {
    ShadingOptions shading;
    PictureOptions picture;
    double wo_theta_deg = 45.0;
    std::vector<double> wo;
};

glm::dvec3 viewer(const Arguments& arguments) {
    if (!arguments.wo.empty()) return unit_direction("--wo", arguments.wo);
    require_range("--wo-theta", arguments.wo_theta_deg, 0.0, kMaxTheta_deg);
    return direction_at(arguments.wo_theta_deg);
}

void run(const Arguments& arguments) {
    const glm::dvec3 wo = viewer(arguments);
    require_image_output(arguments.picture.output);
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
    std::vector<glm::dvec4> rows = shading.backend->run(job).rows;
    if (is_display_format(arguments.picture.output))
        for (glm::dvec4& row : rows) row *= std::numbers::pi;
    write_image(arguments.picture.output, paint(grid, rows),
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
    command->add_option("--wo", arguments->wo, "Unit direction X,Y,Z to the viewer")
        ->delimiter(',')
        ->expected(3)
        ->excludes(theta);
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
