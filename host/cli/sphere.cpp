// `lacquer sphere`: a picture of a lit sphere.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/picture.h"
#include "cli/textured_material.h"
#include "compare/grids.h"
#include "core/progress.h"
#include "image/image_file.h"

namespace lacquer {

namespace {

// Pixels with a material of their own that are shaded at a time.
constexpr std::size_t kTexturedBatch = 1 << 15;

constexpr const char* kSummary = "Draw a lit sphere";

constexpr const char* kHelp =
    R"(Draws a sphere in orthographic projection under a directional light of irradiance pi: a white
Lambertian surface facing the light has radiance 1. The viewer looks along -z, x points right,
y up. Textures are looked up at longitude and latitude, the middle of the picture facing the
viewer. An EXR holds radiance in linear RGB, alpha 1 on the sphere; a PNG shows it through the
tone curve 1 - exp(-x), encoded for a display.

Examples:
  lacquer sphere --material gold -o gold.png
  lacquer sphere --material mine.json --light 0,0.6,0.8 --size 1024 --backend glsl -o mine.exr)";

struct Arguments {
    ShadingOptions shading;
    PictureOptions picture;
    std::vector<double> light;
};

Job sphere_job(const Shading& shading, const QueryGrid& grid) {
    Job job;
    job.model = shading.model;
    job.kernel = grid.kernel;
    job.parameters = grid.parameters;
    return job;
}

std::vector<glm::dvec4> shade_uniform(const Shading& shading, const QueryGrid& grid) {
    Job job = sphere_job(shading, grid);
    job.materials = {&shading.material, 1};
    job.queries_per_material = grid.query_count();
    job.inputs = grid.inputs;
    return shading.backend->run(job).rows;
}

// One material per pixel, in batches that fit in memory.
std::vector<glm::dvec4> shade_textured(const Shading& shading, const QueryGrid& grid) {
    const TexturedMaterial textured{shading.material};
    Progress progress{"sphere", grid.query_count()};
    std::vector<glm::dvec4> rows;
    rows.reserve(grid.query_count());
    for (std::size_t first = 0; first < grid.query_count(); first += kTexturedBatch) {
        const std::size_t count = std::min(kTexturedBatch, grid.query_count() - first);
        std::vector<Material> materials;
        materials.reserve(count);
        for (std::size_t i = 0; i < count; ++i)
            materials.push_back(textured.at(sphere_uv(grid, first + i)));
        Job job = sphere_job(shading, grid);
        job.materials = materials;
        job.inputs = std::span{grid.inputs}.subspan(2 * first, 2 * count);
        const JobResult result = shading.backend->run(job);
        rows.insert(rows.end(), result.rows.begin(), result.rows.end());
        progress.advance(count);
    }
    return rows;
}

void run(const Arguments& arguments) {
    const glm::dvec3 light =
        arguments.light.empty() ? default_light() : unit_direction("--light", arguments.light);
    require_image_output(arguments.picture.output);
    const Shading shading = open_shading(arguments.shading);
    const QueryGrid grid = sphere_grid("sphere", light, arguments.picture.size);
    const std::vector<glm::dvec4> rows = shading.material.textures.empty()
                                             ? shade_uniform(shading, grid)
                                             : shade_textured(shading, grid);
    write_image(arguments.picture.output, paint(grid, rows),
                picture_metadata(arguments.shading, shading));
}

}  // namespace

void add_sphere_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("sphere", kSummary)->footer(kHelp);
    add_shading_options(*command, arguments->shading);
    add_picture_options(*command, arguments->picture);
    command
        ->add_option("--light", arguments->light,
                     "Unit direction X,Y,Z to the light (default: from the upper left)")
        ->delimiter(',')
        ->expected(3);
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
