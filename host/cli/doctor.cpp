// `lacquer doctor`: what can run here, and what to do about the rest.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "backends/backend.h"
#include "cli/commands.h"
#include "cli/options.h"
#include "core/error.h"
#include "core/paths.h"
#include "core/process.h"
#include "core/table.h"
#include "core/version.h"

namespace lacquer {

namespace {

constexpr const char* kSummary = "Say what can run here, and what to do about the rest";

constexpr const char* kHelp =
    R"(Tries every backend and says which can run here, on which device, and for each that cannot,
why and what to install. Ends with exit code 0 whatever it finds.

Examples:
  lacquer doctor
  lacquer doctor --device nvidia --json)";

struct Arguments {
    BackendOptions options;
    bool json = false;
};

// One thing that was looked for.
struct Finding {
    std::string name;
    bool usable = false;
    std::string detail;  // the device or version; otherwise the reason
    std::string remedy;
};

Finding probe_backend(const BackendEntry& entry, const BackendOptions& options) {
    const Availability availability = entry.probe(options);
    return {std::string{entry.name}, availability.usable, availability.detail, availability.remedy};
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

// A program that is asked for its version.
Finding probe_program(const std::string& name, const std::optional<std::filesystem::path>& program,
                      const std::string& remedy) {
    if (!program) return {name, false, "not found", remedy};
    try {
        const ProcessResult result = run_process(*program, {"--version"});
        if (result.exit_code == 0)
            return {name, true, fmt::format("{} ({})", first_line(result.out), program->string()),
                    ""};
        return {name, false, fmt::format("'{}' ends with {}", program->string(), result.exit_code),
                remedy};
    } catch (const Error& error) {
        return {name, false, error.what(), remedy};
    }
}

Finding probe_data() {
    try {
        for (const char* part : {"shaders/manifest.json", "materials", "tables"}) share_file(part);
        return {"data", true, share_folder().string(), ""};
    } catch (const Error& error) {
        return {"data", false, error.what(), "build the target lacquer_program, or reinstall"};
    }
}

std::vector<Finding> probe_tools() {
    return {probe_data(), probe_program("node", node_program(), node_missing_message()),
            probe_program("chromium", find_program("chromium"),
                          "install the package chromium: WebGPU backends use its Vulkan driver"),
            probe_program("wine", find_wine(),
                          "install the package wine64 to run HLSL through its own compilers")};
}

std::string table_text(const std::vector<Finding>& findings, const std::string& title) {
    std::vector<std::vector<std::string>> rows;
    for (const Finding& finding : findings) {
        rows.push_back({finding.name, finding.usable ? "yes" : "no", finding.detail});
        if (!finding.remedy.empty()) rows.push_back({"", "", "-> " + finding.remedy});
    }
    return format_table({{title}, {"usable"}, {"device, version or reason"}}, rows);
}

nlohmann::ordered_json findings_json(const std::vector<Finding>& findings) {
    auto list = nlohmann::ordered_json::array();
    for (const Finding& finding : findings)
        list.push_back({{"name", finding.name},
                        {"usable", finding.usable},
                        {"detail", finding.detail},
                        {"remedy", finding.remedy}});
    return list;
}

void run(const Arguments& arguments) {
    std::vector<Finding> backends;
    for (const BackendEntry& entry : all_backends())
        backends.push_back(probe_backend(entry, arguments.options));
    const std::vector<Finding> tools = probe_tools();
    if (arguments.json) {
        const nlohmann::ordered_json json{{"version", kVersion},
                                          {"backends", findings_json(backends)},
                                          {"tools", findings_json(tools)}};
        return print_data(json.dump(2) + "\n");
    }
    print_data(fmt::format("lacquer {}\n\n{}\n{}", kVersion, table_text(backends, "backend"),
                           table_text(tools, "tool")));
}

}  // namespace

void add_doctor_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("doctor", kSummary)->footer(kHelp);
    add_device_options(*command, arguments->options);
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
