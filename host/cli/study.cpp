#include "cli/study.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>

#include "cli/options.h"
#include "core/error.h"
#include "core/progress.h"
#include "report/folder.h"
#include "study/folder.h"
#include "study/json.h"
#include "study/summary.h"

namespace lacquer {

namespace {

constexpr std::array kBackendOptions{"--backend",    "--material", "--model",        "--device",
                                     "--validation", "--markdown", "--update-readme"};
constexpr std::array kStudyOptions{"--samples", "--seed"};

}  // namespace

const study::Suite* suite_from_name(const std::string& name, const std::string& backends) {
    if (name == backends) return nullptr;
    if (const study::Suite* suite = study::find_suite(name)) return suite;
    std::string names = backends;
    for (const study::Suite& suite : study::all_suites()) names += fmt::format(", {}", suite.name);
    throw UsageError{fmt::format("--suite: '{}' is not one of: {}", name, names)};
}

void require_suite_options(const CLI::App& command, const std::string& suite, bool is_study) {
    const auto refuse = [&](const auto& options) {
        for (const char* option : options)
            if (command.count(option) > 0)
                throw UsageError{fmt::format("{} does not go with --suite {}", option, suite)};
    };
    is_study ? refuse(kBackendOptions) : refuse(kStudyOptions);
}

void run_study_suite(const study::Suite& suite, const SimulateOptions& simulate,
                     const std::filesystem::path& report, bool json) {
    study::StudyRun run;
    run.samples = walk_count(simulate, study::kDefaultSamples);
    if (run.samples < study::kLeastSamples)
        throw UsageError{
            fmt::format("--samples: {} is not in [{}, ...]: too few walks for a picture",
                        run.samples, study::kLeastSamples)};
    run.seed = static_cast<std::uint64_t>(simulate.seed);
    if (!report.empty()) require_report_folder(report);
    study::StudyResult result;
    {
        Progress progress{std::string{suite.name}, suite.figures.size()};
        run.on_part = [&](std::string_view part) { progress.note(part); };
        result = study::run_study(suite, run, [&] { progress.advance(); });
    }
    if (!report.empty()) study::write_study(result, report);
    print_data(json ? study::study_json(result) : study::summary_text(result));
    if (!report.empty()) fmt::print(stderr, "report: {}\n", (report / "report.html").string());
}

}  // namespace lacquer
