// `lacquer`: chooses the command, and turns what it throws into a message and an exit code.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "cli/commands.h"
#include "core/error.h"
#include "core/version.h"

namespace {

constexpr int kSuccess = 0;
constexpr int kFailure = 1;
constexpr int kUsage = 2;

void add_commands(CLI::App& app) {
    lacquer::add_compare_command(app);
    lacquer::add_bench_command(app);
    lacquer::add_eval_command(app);
    lacquer::add_albedo_command(app);
    lacquer::add_interface_command(app);
    lacquer::add_heightfield_command(app);
    lacquer::add_slice_command(app);
    lacquer::add_sphere_command(app);
    lacquer::add_export_command(app);
    lacquer::add_bake_command(app);
#ifdef LACQUER_HAS_VIEWER
    lacquer::add_view_command(app);
#endif
    lacquer::add_doctor_command(app);
    app.require_subcommand(1);
}

int report(int code, const char* message) {
    std::fputs(fmt::format("lacquer: {}\n", message).c_str(), stderr);
    return code;
}

std::string command_list(const CLI::App& app) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names += (names.empty() ? "" : ", ") + command->get_name();
    return names;
}

int usage_error(const CLI::App& app, const CLI::ParseError& error) {
    std::string message = error.what();
    std::string command = "lacquer";
    if (app.get_subcommands().empty()) {
        const std::vector<std::string> rest = app.remaining();
        message = rest.empty() ? "a command is missing; there are: "
                               : fmt::format("'{}' is not one of: ", rest.front());
        message += command_list(app);
    } else {
        command += " " + app.get_subcommands().front()->get_name();
    }
    std::fputs(fmt::format("lacquer: {}\nSee '{} --help'.\n", message, command).c_str(), stderr);
    return kUsage;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"BSDFs of coated and layered surfaces, in every shading language", "lacquer"};
    app.set_version_flag("--version", std::string{"lacquer "} + lacquer::kVersion);
    try {
        add_commands(app);
        app.parse(argc, argv);
        return kSuccess;
    } catch (const CLI::Success& asked) {
        return app.exit(asked);
    } catch (const CLI::ParseError& error) {
        return usage_error(app, error);
    } catch (const lacquer::UsageError& error) {
        return report(kUsage, error.what());
    } catch (const std::exception& error) {
        return report(kFailure, error.what());
    }
}
