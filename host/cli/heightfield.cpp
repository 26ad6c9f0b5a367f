// `lacquer heightfield`: a rough surface as explicit random surfaces, ray traced, beside Smith's
// theory.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/material_argument.h"
#include "cli/options.h"
#include "cli/simulate_options.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/table.h"
#include "heightfield/material_light.h"
#include "report/folder.h"
#include "study/folder.h"
#include "study/heightfields/surface_figure.h"

namespace lacquer {

namespace {

using heightfield::MaterialLight;
using heightfield::ScatteredLight;
using simulator::RgbEstimate;

constexpr std::int64_t kDefaultRays = 1 << 16;
constexpr int kMaxOrders = 8, kMaxSurfaces = 4096, kMinPicture = 8, kMaxPicture = 512;

constexpr const char* kSummary = "Trace rays on random heightfields, beside Smith's theory";

constexpr const char* kHelp =
    R"(Makes the material's rough surface as Gaussian heightfields, stretched stratum by stratum where
the material is an asymmetric blend, sends rays to them and follows each through all the facets it
meets. Prints the share of light that leaves after 1, 2, ... facets, beside that of the simulator's
walks by Smith's theory, which takes neighbouring facets as independent; the mean over the channels,
or, with --json, each channel. Standard errors are those between surfaces.

The material is one rough surface alone: a conductor, diffuse facets, or one interface over nothing,
its facets `beckmann`. With more --correlation the surfaces are smoother between their heights, with
more --grid they are larger; energies change by 0.001 between 12 and 32 cells per correlation length.

Examples:
  lacquer heightfield --material eroded_mirror.json --theta 0.75,1.5
  lacquer heightfield --material eroded_mirror.json --report report --realisations 64)";

struct Arguments {
    std::string material;
    std::vector<double> thetas{0.75, 1.5};
    int orders = 3;
    heightfield::FieldGrid grid{768, 12.0};
    int surfaces = 16;
    int picture_size = 96;
    SimulateOptions simulate;
    std::filesystem::path report;
    bool json = false;
};

// Order "1", "2", ..., and "more" for the last.
std::string order_key(const ScatteredLight& light, std::size_t order) {
    return order + 1 < light.orders.size() ? std::to_string(order + 1) : "more";
}

double mean_of(const Rgb& rgb) {
    return (rgb[0] + rgb[1] + rgb[2]) / 3.0;
}

std::string table_text(const MaterialLight& light) {
    std::vector<std::vector<std::string>> rows;
    const auto add = [&](double theta, const std::string& what, const RgbEstimate& traced,
                         const RgbEstimate& walked) {
        rows.push_back({fmt::format("{:g}", theta), what,
                        fmt::format("{:.4f}", mean_of(traced.mean)),
                        fmt::format("{:.4f}", mean_of(traced.standard_error)),
                        fmt::format("{:.4f}", mean_of(walked.mean)),
                        fmt::format("{:.4f}", mean_of(walked.standard_error)),
                        fmt::format("{:+.4f}", mean_of(walked.mean) - mean_of(traced.mean))});
    };
    for (std::size_t n = 0; n < light.thetas.size(); ++n) {
        const ScatteredLight &traced = light.traced[n], &walked = light.walked[n];
        for (std::size_t order = 0; order < traced.orders.size(); ++order)
            add(light.thetas[n], order_key(traced, order), traced.orders[order].energy,
                walked.orders[order].energy);
        add(light.thetas[n], "all", traced.reflected, walked.reflected);
        if (mean_of(traced.transmitted.mean) > 0.0)
            add(light.thetas[n], "transmitted", traced.transmitted, walked.transmitted);
    }
    return format_table({{"theta", Align::right},
                         {"order"},
                         {"heightfield", Align::right},
                         {"standard error", Align::right},
                         {"Smith", Align::right},
                         {"standard error", Align::right},
                         {"difference", Align::right}},
                        rows);
}

using Json = nlohmann::ordered_json;

// `value` is the mean or the standard error of an estimate.
Json json_of(const ScatteredLight& light, Rgb RgbEstimate::*value) {
    Json orders;
    for (std::size_t order = 0; order < light.orders.size(); ++order)
        orders[order_key(light, order)] = light.orders[order].energy.*value;
    orders["all"] = light.reflected.*value;
    return {{"orders", orders}, {"transmitted", light.transmitted.*value}};
}

Json json_of(const ScatteredLight& light) {
    Json json = json_of(light, &RgbEstimate::mean);
    json["stderr"] = json_of(light, &RgbEstimate::standard_error);
    return json;
}

std::string json_text(const MaterialLight& light) {
    Json rows = Json::array();
    for (std::size_t n = 0; n < light.thetas.size(); ++n) {
        Json traced = json_of(light.traced[n]);
        traced["strays"] = light.traced[n].strays;
        rows.push_back({{"theta", light.thetas[n]},
                        {"heightfield", traced},
                        {"smith", json_of(light.walked[n])}});
    }
    return Json{{"material", light.material.name},
                {"grid", light.grid.cells},
                {"correlation", light.grid.cells_per_length},
                {"realisations", light.options.repetitions},
                {"samples", light.options.rays},
                {"seed", light.options.seed},
                {"rows", rows}}
               .dump(2) +
           "\n";
}

void require_arguments(const Arguments& arguments) {
    for (const double theta : arguments.thetas)
        require_range("--theta", theta, 0.0, heightfield::kMaxTheta);
    require_range("--orders", arguments.orders, 1, kMaxOrders);
    require_range("--realisations", arguments.surfaces, 2, kMaxSurfaces);
    require_range("--size", arguments.picture_size, kMinPicture, kMaxPicture);
    require_range("--grid", arguments.grid.cells, heightfield::kMinCells, heightfield::kMaxCells);
    require_range("--correlation", arguments.grid.cells_per_length, heightfield::kMinCellsPerLength,
                  arguments.grid.cells / heightfield::kMinPeriodLengths);
}

MaterialLight measure(const Arguments& arguments, const Material& material) {
    heightfield::LightOptions options;
    options.orders = arguments.orders;
    options.picture_size = arguments.picture_size;
    options.repetitions = static_cast<std::uint64_t>(arguments.surfaces);
    options.rays = walk_count(arguments.simulate, kDefaultRays);
    options.seed = static_cast<std::uint64_t>(arguments.simulate.seed);
    constexpr std::uint64_t kWays = 2;  // traced and walked
    Progress progress{"heightfield",
                      kWays * options.repetitions * options.rays * arguments.thetas.size()};
    options.on_rays = [&progress](std::uint64_t rays) { progress.advance(rays); };
    MaterialLight light =
        heightfield::measure_material(material, arguments.thetas, arguments.grid, options);
    light.options.on_rays = {};
    return light;
}

void write_report(const MaterialLight& light, double seconds, const std::filesystem::path& folder) {
    study::StudyResult result{&study::kHeightfieldSuite,
                              light.options.repetitions * light.options.rays,
                              light.options.seed,
                              seconds,
                              {study::surface_figure(light)}};
    study::write_study(result, folder);
    fmt::print(stderr, "report: {}\n", (folder / "report.html").string());
}

void run(const Arguments& arguments) {
    require_arguments(arguments);
    const Material material = load_material(material_file(arguments.material));
    require_untextured(material);
    if (!arguments.report.empty()) require_report_folder(arguments.report);
    const auto start = std::chrono::steady_clock::now();
    const MaterialLight light = measure(arguments, material);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    if (!arguments.report.empty()) write_report(light, seconds.count(), arguments.report);
    print_data(arguments.json ? json_text(light) : table_text(light));
}

}  // namespace

void add_heightfield_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("heightfield", kSummary)->footer(kHelp);
    command->add_option("--material", arguments->material, "Material file, or a bundled name")
        ->required();
    command
        ->add_option("--theta", arguments->thetas,
                     "Angles of the light from the normal, T[,T...], in radians, 0 to 1.57")
        ->delimiter(',')
        ->capture_default_str();
    command
        ->add_option("--orders", arguments->orders, "Numbers of facets that are told apart, 1 to 8")
        ->capture_default_str();
    command
        ->add_option("--grid", arguments->grid.cells, "Cells along a side of a surface, 32 to 4096")
        ->capture_default_str();
    command
        ->add_option("--correlation", arguments->grid.cells_per_length,
                     "Cells per correlation length, 4 to a quarter of --grid")
        ->capture_default_str();
    command->add_option("--realisations", arguments->surfaces, "Surfaces, 2 to 4096")
        ->capture_default_str();
    command
        ->add_option("--size", arguments->picture_size,
                     "Pixels of either side of the report's pictures of light, 8 to 512")
        ->capture_default_str();
    add_walk_options(*command, arguments->simulate,
                     "Rays to each surface from each angle (default 65536)");
    command->add_option("--report", arguments->report,
                        "Folder for report.html, the results as JSON, and pictures");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
