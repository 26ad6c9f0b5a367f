// `lacquer bake`: rebuilds the tables by simulation.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>
#include <memory>

#include "bake/bake.h"
#include "bake/kernel_walks.h"
#include "bake/report.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/file.h"

namespace lacquer {

namespace {

namespace fs = std::filesystem;

constexpr const char* kDefaultFolder = "tables";

constexpr const char* kHelp =
    R"(Simulates the energies of rough interfaces, compresses them, and writes one table a file, with an
EXR of it for eyes. A complete bake judges its tables against fresh simulation, prints how far they
are off, and writes that to the README.md of the folder where there is one with a place for it.

A bake that was killed goes on with --resume and the same other options and number of processes.
The same --samples and --seed give the same bytes, however often it was interrupted or shared.

Examples:
  lacquer bake --report report
  lacquer bake --coarse -o /tmp/tables
  lacquer bake --table mirror --samples 1024 -o /tmp/tables
  mpirun -n 2 lacquer bake --resume -o /tmp/tables)";

// The C++ walks of host/bake, which no backend runs.
constexpr std::string_view kHost = "host";

struct BakeArguments {
    std::vector<std::string> tables;
    std::uint64_t samples = 0;  // 0: the preset's
    std::int64_t seed = 1;      // signed, so that one below 0 is refused
    bool coarse = false;
    bool resume = false;
    std::string report;
    std::string folder;  // empty: kDefaultFolder
    std::string backend{kHost};
    BackendOptions backend_options;
};

// How much is simulated unless asked otherwise.
struct Preset {
    std::uint64_t samples;
    std::size_t points;         // random points that each check looks at
    std::size_t point_samples;  // walks of each
};

constexpr Preset kDefault{1 << 14, 2000, 1 << 14};
constexpr Preset kCoarse{1 << 7, 100, 1 << 10};
constexpr std::size_t kGridStride = 7;  // of the comparison with the dense bake, which is large

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string command_text(const BakeArguments& arguments, std::uint64_t samples) {
    std::string text = fmt::format("lacquer bake{} --samples {} --seed {}",
                                   arguments.coarse ? " --coarse" : "", samples, arguments.seed);
    if (arguments.backend != kHost) text += " --backend " + arguments.backend;
    return text;
}

fs::path folder_of(const BakeArguments& arguments) {
    return arguments.folder.empty() ? kDefaultFolder : arguments.folder;
}

void make_folder(const fs::path& folder) {
    std::error_code failure;
    fs::create_directories(folder, failure);
    if (failure)
        throw Error{fmt::format("making folder '{}': {}", folder.string(), failure.message())};
}

// What may walk: the host, and the backends that have the kernels.
std::vector<std::string> walkers() {
    std::vector<std::string> names{std::string{kHost}};
    for (const BackendEntry& entry : all_backends())
        if (entry.name != "reference") names.emplace_back(entry.name);
    return names;
}

std::unique_ptr<bake::Walks> open_walks(const BakeArguments& arguments, std::size_t samples) {
    if (arguments.backend == kHost) return std::make_unique<bake::HostWalks>(samples);
    const BackendEntry& entry = backend_from_name(arguments.backend);
    return std::make_unique<bake::KernelWalks>(arguments.backend,
                                               entry.create(arguments.backend_options), samples);
}

bool wanted(const BakeArguments& arguments, const std::string& name) {
    const auto& names = arguments.tables;
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

// Judges a complete set of tables and writes what people read about it.
void publish(const BakeArguments& arguments, const Preset& preset,
             const std::vector<bake::TableBake>& bakes, const std::vector<bake::BakedTable>& baked,
             bake::BakeRecord record) {
    std::array<Table, kTableNames.size()> tables;
    for (std::size_t n = 0; n < tables.size(); ++n) tables[n] = baked[n].table;
    const EnergyTables energies{tables};
    for (std::size_t n = 0; n < bakes.size(); ++n)
        record.tables[n].on_grid =
            bake::judge_on_grid(bakes[n].quantities, baked[n].dense, energies, kGridStride);
    // A seed of its own: points and walks that the bake has not seen.
    const bake::BakeSettings fresh{preset.point_samples, record.settings.seed + 1};
    for (const bake::Check& check : bake::all_checks())
        record.checks.push_back(
            {check.name, bake::judge_off_grid(check, energies, preset.points, fresh)});
    record.points = preset.points;
    record.point_samples = preset.point_samples;

    const std::string text = bake::accuracy_text(record);
    fmt::print("{}", text);
    const fs::path readme = folder_of(arguments) / "README.md";
    if (fs::exists(readme)) write_file(readme, bake::with_accuracy(read_file(readme), text));
    if (arguments.report.empty()) return;
    for (const std::size_t n : {0, 1})  // the tables of T01
        for (bake::Truncation& each : bake::truncation_errors(
                 tables, n, bakes[n].quantities.front(), baked[n].dense.front()))
            record.truncations.push_back(std::move(each));
    write_file(fs::path{arguments.report} / "tables.html", bake::report_page(energies, record));
}

// Throws UsageError for options that do not go together.
void require_sense(const BakeArguments& arguments) {
    if (!arguments.report.empty() && !arguments.tables.empty())
        throw UsageError{"--report needs all tables: leave --table out"};
    if (arguments.coarse && arguments.folder.empty())
        throw UsageError{"--coarse makes noisy tables: say with -o where they may lie"};
    const BackendOptions& options = arguments.backend_options;
    if (arguments.backend == kHost && (!options.device.empty() || options.validation))
        throw UsageError{"--device and --validation go with a --backend that runs on Vulkan"};
}

void run(const BakeArguments& arguments) {
    require_sense(arguments);
    const bake::Ranks ranks;
    if (ranks.first() && ranks.count() > 1)
        fmt::print(stderr, "{} processes share the bake\n", ranks.count());
    const Preset& preset = arguments.coarse ? kCoarse : kDefault;
    bake::BakeRun run;
    run.settings.samples = arguments.samples != 0 ? arguments.samples : preset.samples;
    run.settings.seed = static_cast<std::uint64_t>(arguments.seed);
    run.folder = folder_of(arguments);
    run.resume = arguments.resume;
    make_folder(run.folder);
    if (!arguments.report.empty()) make_folder(arguments.report);

    const std::unique_ptr<bake::Walks> walks = open_walks(arguments, run.settings.samples);
    bake::BakeRecord record;
    record.command = command_text(arguments, run.settings.samples);
    record.settings = run.settings;
    std::vector<bake::TableBake> bakes;
    std::vector<bake::BakedTable> baked;
    for (bake::TableBake& each : bake::all_table_bakes()) {
        if (!wanted(arguments, each.name)) continue;
        const auto start = std::chrono::steady_clock::now();
        baked.push_back(bake::bake_table(each, *walks, run, ranks));
        record.tables.push_back(
            {each.name, payload_bytes(baked.back().table), seconds_since(start), {}});
        bakes.push_back(std::move(each));
    }
    if (!ranks.first()) return;
    if (baked.size() == kTableNames.size())
        publish(arguments, preset, bakes, baked, std::move(record));
    for (const bake::TableBake& each : bakes) bake::discard_checkpoints(each, run);
}

}  // namespace

void add_bake_command(CLI::App& app) {
    auto arguments = std::make_shared<BakeArguments>();
    CLI::App* command =
        app.add_subcommand("bake", "Rebuild the tables by simulation")->footer(kHelp);
    command->add_option("--table", arguments->tables, "Bake this one only (repeatable)")
        ->check(CLI::IsMember(std::vector<std::string>{kTableNames.begin(), kTableNames.end()}));
    command
        ->add_option("--samples", arguments->samples, "Walks per node (default 16384; coarse: 128)")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 24));
    command->add_option("--seed", arguments->seed, "Seed of all walks (default 1)")
        ->check(CLI::Range(std::int64_t{0}, std::numeric_limits<std::int64_t>::max()));
    command->add_flag("--coarse", arguments->coarse, "Few walks: noisy tables in seconds");
    command->add_flag("--resume", arguments->resume, "Go on with a bake that was interrupted");
    command->add_option("--report", arguments->report, "Folder for a page of plots, tables.html");
    command->add_option("-o,--output", arguments->folder, "Folder of the tables (default tables)");
    command
        ->add_option("--backend", arguments->backend,
                     "What walks: 'host', the low-noise C++ walks, or a backend that runs the "
                     "shader source's, noisier for the same number (default host)")
        ->check(CLI::IsMember(walkers()));
    add_device_options(*command, arguments->backend_options);
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
