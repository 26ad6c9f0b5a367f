// `lacquer bench`: how fast the backends and the simulator are.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>

#include "backends/backend.h"
#include "cli/commands.h"
#include "cli/material_argument.h"
#include "cli/median.h"
#include "cli/options.h"
#include "cli/walk_rate.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/table.h"
#include "core/version.h"

namespace lacquer {

namespace {

constexpr std::int64_t kDefaultQueries = std::int64_t{1} << 20;
constexpr int kMaxRuns = 1000;

// What a shading point costs is measured with one light and with these more, at one point for this
// many queries.
constexpr std::uint32_t kMoreLights = 32;
constexpr std::uint64_t kQueriesPerPoint = 16;

constexpr const char* kSummary = "Measure how fast the backends and the simulator are";

constexpr const char* kHelp =
    R"(Measures how many pairs of directions each backend evaluates per second: the median of several
runs, compilation left out, moving data to and from the device included. `/ copy` is the time
as a multiple of a kernel that moves the same bytes and computes nothing, `/ plain` as a
multiple of the model plain. `device` is the rate of the kernel alone by the device's own
clock, where it has one. On a shared machine only the ratios mean much.

`first light` is what preparing a shading point and shading one light cost, `more lights` what each
further light costs, both as multiples of the model plain and by the device's own clock where it
has one.

For the simulator, the rate of light walking through one rough interface between dielectrics, in
millions per second of one core's own time. Left out where --backend names others.

Examples:
  lacquer bench
  lacquer bench --simulator
  lacquer bench --backend vulkan --device nvidia --queries 67108864 --json)";

struct Arguments {
    std::vector<std::string> backends;
    std::string material = "vermilion_lacquer";
    std::string model = "plain";
    std::int64_t queries = kDefaultQueries;
    int runs = 5;
    BackendOptions options;
    bool simulator_only = false;
    bool json = false;
};

// Medians over the runs.
struct Timing {
    double seconds = 0.0;
    std::optional<double> device_seconds;
};

struct Measurement {
    std::string backend, device;
    std::string reason;  // why there are no figures; empty where there are
    Timing model, copy, plain;
    // Time as a multiple of the model plain's.
    double first_light = 1.0;
    double more_lights = 1.0;
};

// A shading point with one light, and what 32 more add; medians, by the device's clock if it can.
struct LightTiming {
    double first = 0.0;
    double more = 0.0;
};

// Directions over the upper hemisphere by the golden angle (Fibonacci lattice), each wi with a wo a
// quarter of the lattice away.
std::vector<glm::vec4> lattice_inputs(std::uint64_t queries) {
    constexpr double kGoldenAngle = std::numbers::pi * 0.7639320225002102;  // 3 - sqrt(5)
    const auto direction = [queries](std::uint64_t i) {
        const double z = (double(i) + 0.5) / double(queries);
        const double radius = std::sqrt((1.0 - z) * (1.0 + z));
        const double azimuth = kGoldenAngle * double(i);
        return glm::vec4{
            glm::dvec4{radius * std::cos(azimuth), radius * std::sin(azimuth), z, 0.0}};
    };
    std::vector<glm::vec4> inputs;
    inputs.reserve(2 * queries);
    for (std::uint64_t i = 0; i < queries; ++i) {
        inputs.push_back(direction(i));
        inputs.push_back(direction((i + queries / 4) % queries));
    }
    return inputs;
}

// Directions over the upper hemisphere, one per shading point.
std::vector<glm::vec4> lattice_viewers(std::uint64_t points) {
    const std::vector<glm::vec4> pairs = lattice_inputs(points);
    std::vector<glm::vec4> viewers;
    for (std::size_t row = 0; row < pairs.size(); row += 2) viewers.push_back(pairs[row]);
    return viewers;
}

Timing time_job(Backend& backend, const Job& job, int runs) {
    backend.prepare(job.model, job.kernel);
    std::vector<double> seconds, device_seconds;
    for (int i = 0; i < runs; ++i) {
        const JobResult result = backend.run(job);
        seconds.push_back(result.seconds);
        if (result.device_seconds) device_seconds.push_back(*result.device_seconds);
    }
    Timing timing{median(seconds), std::nullopt};
    if (!device_seconds.empty()) timing.device_seconds = median(device_seconds);
    return timing;
}

double device_or_all(const Timing& timing) {
    return timing.device_seconds.value_or(timing.seconds);
}

LightTiming time_lights(Backend& backend, Job job, Model model, int runs) {
    job.model = model;
    job.kernel = Kernel::lights;
    job.queries_per_material =
        std::max<std::uint64_t>(job.queries_per_material / kQueriesPerPoint, 1);
    const std::vector<glm::vec4> viewers = lattice_viewers(job.queries_per_material);
    job.inputs = viewers;
    job.parameters.point_count = 1;
    const double first = device_or_all(time_job(backend, job, runs));
    job.parameters.point_count = 1 + kMoreLights;
    return {first, device_or_all(time_job(backend, job, runs)) - first};
}

Measurement measure(const BackendEntry& entry, const Arguments& arguments, Job job,
                    Progress& progress) {
    Measurement measurement{.backend = std::string{entry.name},
                            .device = {},
                            .reason = {},
                            .model = {},
                            .copy = {},
                            .plain = {}};
    const Availability availability = entry.probe(arguments.options);
    if (!availability.usable) {
        measurement.reason = availability.detail;
        return measurement;
    }
    const std::unique_ptr<Backend> backend = entry.create(arguments.options);
    measurement.device = backend->device();
    const auto time = [&](Model model, Kernel kernel) {
        progress.note(fmt::format("{}, {}", entry.name, kernel_shape(kernel).name));
        job.model = model;
        job.kernel = kernel;
        return time_job(*backend, job, arguments.runs);
    };
    const Model model = model_from_name(arguments.model);
    measurement.copy = time(model, Kernel::copy);
    measurement.model = time(model, Kernel::eval);
    measurement.plain =
        model == Model::plain ? measurement.model : time(Model::plain, Kernel::eval);
    if (model == Model::plain) return measurement;
    const LightTiming lights = time_lights(*backend, job, model, arguments.runs);
    const LightTiming plain_lights = time_lights(*backend, job, Model::plain, arguments.runs);
    measurement.first_light = lights.first / plain_lights.first;
    measurement.more_lights = lights.more / plain_lights.more;
    return measurement;
}

std::vector<const BackendEntry*> chosen_backends(const Arguments& arguments) {
    std::vector<const BackendEntry*> entries;
    for (const std::string& name : arguments.backends) entries.push_back(&backend_from_name(name));
    if (entries.empty() && !arguments.simulator_only)
        for (const BackendEntry& entry : all_backends()) entries.push_back(&entry);
    return entries;
}

double rate(std::int64_t queries, double seconds) {
    return seconds > 0.0 ? double(queries) / seconds : 0.0;
}

std::string table_text(const std::vector<Measurement>& measurements, std::int64_t queries) {
    std::vector<std::vector<std::string>> rows;
    for (const Measurement& m : measurements) {
        if (!m.reason.empty()) {
            rows.push_back({m.backend, "-", "-", "-", "-", "-", "-", m.reason});
            continue;
        }
        const std::optional<double>& on_device = m.model.device_seconds;
        rows.push_back({m.backend, fmt::format("{:.2f}", rate(queries, m.model.seconds) * 1e-6),
                        on_device ? fmt::format("{:.2f}", rate(queries, *on_device) * 1e-6) : "-",
                        fmt::format("{:.2f}", m.model.seconds / m.copy.seconds),
                        fmt::format("{:.2f}", m.model.seconds / m.plain.seconds),
                        fmt::format("{:.2f}", m.first_light), fmt::format("{:.2f}", m.more_lights),
                        m.device});
    }
    return format_table({{"backend"},
                         {"Mq/s", Align::right},
                         {"device Mq/s", Align::right},
                         {"/ copy", Align::right},
                         {"/ plain", Align::right},
                         {"first light", Align::right},
                         {"more lights", Align::right},
                         {"device"}},
                        rows);
}

using Json = nlohmann::ordered_json;

Json to_json(const std::vector<Measurement>& measurements, const Arguments& arguments) {
    Json backends = Json::array();
    for (const Measurement& m : measurements) {
        Json backend{{"name", m.backend}, {"device", m.device}, {"reason", m.reason}};
        if (m.reason.empty()) {
            backend["seconds"] = m.model.seconds;
            backend["queries_per_second"] = rate(arguments.queries, m.model.seconds);
            if (m.model.device_seconds)
                backend["device_queries_per_second"] =
                    rate(arguments.queries, *m.model.device_seconds);
            backend["ratio_to_copy"] = m.model.seconds / m.copy.seconds;
            backend["ratio_to_plain"] = m.model.seconds / m.plain.seconds;
            backend["first_light_ratio_to_plain"] = m.first_light;
            backend["more_lights_ratio_to_plain"] = m.more_lights;
        }
        backends.push_back(backend);
    }
    return backends;
}

std::string json_text(const std::vector<Measurement>& measurements,
                      const std::vector<WalkRate>& walk_rates, const Arguments& arguments) {
    Json json{{"version", kVersion},
              {"model", arguments.model},
              {"material", arguments.material},
              {"queries", arguments.queries},
              {"runs", arguments.runs},
              {"backends", to_json(measurements, arguments)}};
    if (!walk_rates.empty()) json["simulator"] = to_json(walk_rates);
    return json.dump(2) + "\n";
}

std::string table_text(const std::vector<Measurement>& measurements,
                       const std::vector<WalkRate>& walk_rates, std::int64_t queries) {
    if (walk_rates.empty()) return table_text(measurements, queries);
    if (measurements.empty()) return table_text(walk_rates);
    return table_text(measurements, queries) + "\n" + table_text(walk_rates);
}

std::vector<Measurement> measure_backends(const Arguments& arguments, Progress& progress,
                                          const std::vector<const BackendEntry*>& entries) {
    const Material material = load_material(material_file(arguments.material));
    require_untextured(material);
    const auto queries = static_cast<std::uint64_t>(arguments.queries);
    const std::vector<glm::vec4> inputs = lattice_inputs(queries);
    Job job;
    job.materials = {&material, 1};
    job.queries_per_material = queries;
    job.inputs = inputs;
    std::vector<Measurement> measurements;
    for (const BackendEntry* entry : entries) {
        measurements.push_back(measure(*entry, arguments, job, progress));
        progress.advance();
    }
    return measurements;
}

void run(const Arguments& arguments) {
    require_range("--queries", double(arguments.queries), 1.0, double(kMaxQueries));
    model_from_name(arguments.model);
    const std::vector<const BackendEntry*> entries = chosen_backends(arguments);
    std::vector<Measurement> measurements;
    std::vector<WalkRate> walk_rates;
    {
        const bool with_simulator = arguments.backends.empty();
        Progress progress{"bench", entries.size() + (with_simulator ? 1 : 0)};
        if (!entries.empty()) measurements = measure_backends(arguments, progress, entries);
        progress.note("simulator");
        if (with_simulator) walk_rates = measure_walk_rates(arguments.runs);
    }
    print_data(arguments.json ? json_text(measurements, walk_rates, arguments)
                              : table_text(measurements, walk_rates, arguments.queries));
    for (const Measurement& m : measurements)
        if (!m.reason.empty() && !arguments.backends.empty())
            throw Error{fmt::format("backend '{}' cannot run here: {}", m.backend, m.reason)};
}

}  // namespace

void add_bench_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("bench", kSummary)->footer(kHelp);
    CLI::Option* backend =
        command
            ->add_option("--backend", arguments->backends,
                         "Backend to measure, may be repeated (default: all that can run)")
            ->allow_extra_args(false);
    command->add_flag("--simulator", arguments->simulator_only, "Measure the simulator only")
        ->excludes(backend);
    command->add_option("--material", arguments->material, "Material file, or a bundled name")
        ->capture_default_str();
    command->add_option("--model", arguments->model, "How it is shaded")->capture_default_str();
    command
        ->add_option("--queries", arguments->queries,
                     fmt::format("Pairs of directions per run, 1 to {}", kMaxQueries))
        ->capture_default_str();
    command->add_option("--runs", arguments->runs, "Runs whose median counts")
        ->check(CLI::Range(1, kMaxRuns))
        ->capture_default_str();
    add_device_options(*command, arguments->options);
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
