// `lacquer albedo`: how much of the light from all directions a material sends to a viewer.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/material_argument.h"
#include "cli/options.h"
#include "cli/simulated_albedo.h"
#include "core/error.h"
#include "core/table.h"

namespace lacquer {

namespace {

// Points of the model's integral, and walks of a simulation per cosine.
constexpr std::int64_t kDefaultPoints = 1024;
constexpr std::int64_t kMaxPoints = 1 << 20;
constexpr std::int64_t kDefaultWalks = 1'000'000;

constexpr const char* kSummary =
    "Compute directional albedos, split by where the light turned back";

constexpr const char* kHelp =
    R"(Computes the directional albedo of a material: the share of light from every direction that
leaves towards a viewer at the angle whose cosine is given, split into `direct` (never reached
the base), `base` (reflected by it) and `transmitted`; `total` is direct + base. A simulation adds
standard errors; its --json also has the number of walks and, for a single interface or a bare base,
`orders`: the light reflected after 1, 2, 3 and all numbers of facets. Ctrl-C ends a simulation and
prints what it found so far.

Examples:
  lacquer albedo --material gold --cos 1,0.5,0.1
  lacquer albedo --material porcelain --cos 0.7 --backend vulkan --samples 4096 --json
  lacquer albedo --material gold --cos 0.7 --method simulate --json)";

struct Arguments {
    ShadingOptions shading;
    std::vector<double> cosines;
    SimulateOptions simulate;
    std::string method = model_method().name;
    bool json = false;
};

struct AlbedoRow {
    double cosine;
    glm::dvec3 direct, base;
    glm::dvec3 transmitted;  // 0 but for stacks without a base

    glm::dvec3 total() const { return direct + base; }
};

std::uint32_t point_count(const Arguments& arguments) {
    const std::int64_t points = arguments.simulate.samples.value_or(kDefaultPoints);
    if (points >= 1 && points <= kMaxPoints) return static_cast<std::uint32_t>(points);
    throw UsageError{fmt::format("--samples: {} is not in [1, {}]", points, kMaxPoints)};
}

glm::vec4 viewer_at(double cosine) {
    const double sine = std::sqrt((1.0 - cosine) * (1.0 + cosine));
    return {static_cast<float>(sine), 0.0f, static_cast<float>(cosine), 0.0f};
}

std::vector<AlbedoRow> compute(const Arguments& arguments) {
    const Shading shading = open_shading(arguments.shading);
    require_untextured(shading.material);
    std::vector<glm::vec4> inputs;
    for (const double cosine : arguments.cosines) inputs.push_back(viewer_at(cosine));
    Job job;
    job.model = shading.model;
    job.kernel = Kernel::albedo;
    job.materials = {&shading.material, 1};
    job.queries_per_material = inputs.size();
    job.inputs = inputs;
    job.parameters.point_count = point_count(arguments);
    const JobResult result = shading.backend->run(job);
    std::vector<AlbedoRow> rows;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        rows.push_back({arguments.cosines[i], glm::dvec3{result.rows[3 * i]},
                        glm::dvec3{result.rows[3 * i + 1]}, glm::dvec3{result.rows[3 * i + 2]}});
    return rows;
}

std::string table_text(const std::vector<AlbedoRow>& rows) {
    const auto color = [](const glm::dvec3& c) {
        return fmt::format("{:.5f} {:.5f} {:.5f}", c.x, c.y, c.z);
    };
    std::vector<std::vector<std::string>> cells;
    for (const AlbedoRow& row : rows)
        cells.push_back({fmt::format("{}", row.cosine), color(row.direct), color(row.base),
                         color(row.transmitted), color(row.total())});
    return format_table({{"cos", Align::right}, {"direct"}, {"base"}, {"transmitted"}, {"total"}},
                        cells);
}

std::string json_text(const std::vector<AlbedoRow>& rows) {
    using Json = nlohmann::ordered_json;
    const auto color = [](const glm::dvec3& c) { return Json{c.x, c.y, c.z}; };
    Json list = Json::array();
    for (const AlbedoRow& row : rows)
        list.push_back({{"cos", row.cosine},
                        {"direct", color(row.direct)},
                        {"base", color(row.base)},
                        {"transmitted", color(row.transmitted)},
                        {"total", color(row.total())}});
    return Json{{"rows", list}}.dump(2) + "\n";
}

void simulate(const Arguments& arguments) {
    const Material material = load_material(material_file(arguments.shading.material));
    require_untextured(material);
    print_simulated_albedo(material, arguments.cosines,
                           walk_count(arguments.simulate, kDefaultWalks), arguments.simulate,
                           arguments.json);
}

void run(const CLI::App& command, const Arguments& arguments) {
    for (const double cosine : arguments.cosines) require_range("--cos", cosine, 0.0, 1.0);
    require_method(command, arguments.method,
                   std::array{model_method(), Method{kSimulateMethod, {"--seed", "--orders"}}});
    if (arguments.method == kSimulateMethod) return simulate(arguments);
    const std::vector<AlbedoRow> rows = compute(arguments);
    print_data(arguments.json ? json_text(rows) : table_text(rows));
}

}  // namespace

void add_albedo_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("albedo", kSummary)->footer(kHelp);
    add_shading_options(*command, arguments->shading);
    command
        ->add_option("--cos", arguments->cosines, "Cosines of the viewer's angle, C[,C...], 0 to 1")
        ->delimiter(',')
        ->required();
    command->add_option("--method", arguments->method, "How: model or simulate")
        ->capture_default_str();
    add_walk_options(*command, arguments->simulate,
                     "Points of the integral, where the model has no closed form (default 1024); "
                     "walks per cosine of a simulation (default 1000000)");
    add_orders_option(*command, arguments->simulate);
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([command, arguments] { run(*command, *arguments); });
}

}  // namespace lacquer
