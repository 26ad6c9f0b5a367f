// `lacquer compare`: every backend against the reference.
#include "compare/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/commands.h"
#include "cli/material_argument.h"
#include "cli/options.h"
#include "cli/study.h"
#include "core/error.h"
#include "core/model_scope.h"
#include "core/progress.h"
#include "report/folder.h"
#include "report/json.h"
#include "report/text.h"

namespace lacquer {

namespace {

constexpr std::string_view kReferenceName = "reference";
constexpr std::string_view kDefaultSuite = "default";

constexpr const char* kSummary =
    "Compare every backend with the reference, or the models with simulated light";

constexpr const char* kHelp =
    R"(Runs the generated shaders of every language on slices and spheres of every material and
compares them with the reference in double precision. Prints one line per backend: its largest
errors, its throughput and device. Ends with exit code 1 where a backend is past its tolerance
or breaks down. Backends that cannot run here are skipped, unless they were named.

With --suite diffuse-interfaces it makes the figures of the paper on rough coats over Lambertian
bases instead, with --suite layered those of the paper on stacks of layers, with --suite
heightfields those of the paper on surfaces that change with height: what simulated light does, what
each model makes of it, and how far it is off. Prints the errors; --report writes a page with all
pictures and curves.

Examples:
  lacquer compare
  lacquer compare --backend vulkan --backend wgsl-wgpu --material gold --report report
  lacquer compare --device nvidia --json > compare.json
  lacquer compare --update-readme README.md
  lacquer compare --suite diffuse-interfaces --report report
  lacquer compare --suite layered --report report
  lacquer compare --suite heightfields --report report)";

struct Arguments {
    std::vector<std::string> backends;
    std::vector<std::string> materials;
    std::string model = "plain";
    std::string suite{kDefaultSuite};
    BackendOptions options;
    SimulateOptions simulate;
    std::filesystem::path report;
    std::filesystem::path readme;
    bool json = false;
    bool markdown = false;
};

std::vector<const BackendEntry*> chosen_backends(const std::vector<std::string>& names) {
    std::vector<const BackendEntry*> entries;
    for (const std::string& name : names) entries.push_back(&backend_from_name(name));
    if (!names.empty()) return entries;
    for (const BackendEntry& entry : all_backends())
        if (entry.name != kReferenceName) entries.push_back(&entry);
    return entries;
}

// The bundled materials that the model can shade, saying which it leaves out.
std::vector<NamedMaterial> bundled_materials(Model model) {
    std::vector<NamedMaterial> materials;
    for (const std::filesystem::path& file : bundled_material_files()) {
        const NamedMaterial named{file.stem().string(), load_material(file)};
        if (const auto why = why_not_shadeable(named.material, model))
            fmt::print(stderr, "left out: {}: {}\n", named.name, *why);
        else
            materials.push_back(named);
    }
    return materials;
}

std::vector<NamedMaterial> chosen_materials(const std::vector<std::string>& names, Model model) {
    std::vector<NamedMaterial> materials;
    for (const std::string& name : names) {
        materials.push_back({name, load_material(material_file(name))});
        require_model(materials.back().material, model);
    }
    if (names.empty()) materials = bundled_materials(model);
    for (const NamedMaterial& named : materials) require_untextured(named.material);
    return materials;
}

CompareRequest make_request(const Arguments& arguments) {
    CompareRequest request;
    request.suite = arguments.suite;
    request.model = model_from_name(arguments.model);
    request.backends = chosen_backends(arguments.backends);
    request.reference = &backend_from_name(kReferenceName);
    request.materials = chosen_materials(arguments.materials, request.model);
    request.grids = default_suite();
    request.options = arguments.options;
    request.keep_values = !arguments.report.empty();
    return request;
}

CompareResult run_with_progress(CompareRequest request) {
    Progress progress{"compare", step_count(request)};
    bool first = true;
    request.on_step = [&](std::string_view what) {
        if (!first) progress.advance();
        first = false;
        progress.note(what);
    };
    return run_compare(request);
}

// Lines for the end: what failed, and what was asked for by name but could not run.
std::vector<std::string> complaints(const Arguments& arguments, const CompareResult& result) {
    std::vector<std::string> lines = failures(result);
    for (const BackendResult& backend : result.backends)
        if (backend.status == Status::skipped &&
            std::ranges::find(arguments.backends, backend.name) != arguments.backends.end())
            lines.push_back(
                fmt::format("backend '{}' cannot run here: {}", backend.name, backend.reason));
    return lines;
}

void run(const Arguments& arguments) {
    CompareRequest request = make_request(arguments);
    if (!arguments.report.empty()) require_report_folder(arguments.report);
    const CompareResult result = run_with_progress(std::move(request));
    if (!arguments.report.empty()) write_report(result, arguments.report);
    print_data(arguments.json       ? compare_json(result)
               : arguments.markdown ? accuracy_markdown(result)
                                    : summary_table(result));
    if (!arguments.report.empty())
        fmt::print(stderr, "report: {}\n", (arguments.report / "report.html").string());
    const std::vector<std::string> lines = complaints(arguments, result);
    if (!lines.empty()) throw Error{fmt::format("{}", fmt::join(lines, "\nlacquer: "))};
    if (!arguments.readme.empty()) update_markdown(arguments.readme, accuracy_markdown(result));
}

}  // namespace

void add_compare_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("compare", kSummary)->footer(kHelp);
    command
        ->add_option("--backend", arguments->backends,
                     "Backend to compare, may be repeated (default: all that can run)")
        ->allow_extra_args(false);
    CLI::Option* material =
        command
            ->add_option("--material", arguments->materials,
                         "Material file or bundled name, may be repeated (default: all bundled)")
            ->allow_extra_args(false);
    command->add_option("--model", arguments->model, "How materials are shaded")
        ->capture_default_str();
    command
        ->add_option(
            "--suite", arguments->suite,
            "default (the backends), or the figures of a paper: diffuse-interfaces, layered")
        ->capture_default_str();
    add_walk_options(*command, arguments->simulate,
                     "Walks of light in each simulated picture of a paper's figures "
                     "(default: 4194304)");
    add_device_options(*command, arguments->options);
    command->add_option("--report", arguments->report,
                        "Folder for report.html, the results as JSON, and pictures");
    CLI::Option* json = command->add_flag("--json", arguments->json, "Print JSON");
    command->add_flag("--markdown", arguments->markdown, "Print the accuracy table in Markdown")
        ->excludes(json);
    // The table speaks of all bundled materials: it must not be made from some.
    command
        ->add_option("--update-readme", arguments->readme,
                     "Replace the accuracy table between its markers in this Markdown file")
        ->excludes(material);
    command->callback([arguments, command] {
        const study::Suite* suite = suite_from_name(arguments->suite, std::string{kDefaultSuite});
        require_suite_options(*command, arguments->suite, suite != nullptr);
        if (suite != nullptr)
            run_study_suite(*suite, arguments->simulate, arguments->report, arguments->json);
        else
            run(*arguments);
    });
}

}  // namespace lacquer
