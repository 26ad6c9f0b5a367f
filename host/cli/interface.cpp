// `lacquer interface`: the energies of one rough dielectric interface over an absorbing medium.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "core/error.h"
#include "core/paths.h"
#include "simulator/interface.h"
#include "tables/energy_tables.h"

namespace lacquer {

namespace {

struct InterfaceArguments {
    double alpha = 0.0, eta = 1.5, tau = 1.0, cos_theta = 1.0;
    std::string ndf = "ggx";
    std::string method = "table";
    std::uint64_t samples = 1'000'000;
    std::uint64_t seed = 1;
    bool json = false;
};

// A value and, where it was simulated, its standard error.
struct Row {
    std::string name;
    double value = 0.0;
    double standard_error = 0.0;
};

std::vector<Row> look_up(const InterfaceArguments& arguments) {
    if (arguments.ndf != "ggx")
        throw UsageError{"--ndf: the tables are of ggx facets; use --method simulate"};
    const EnergyTables tables{share_folder() / "tables"};
    const auto [alpha, eta, tau] = std::array{arguments.alpha, arguments.eta, arguments.tau};
    return {{"T01", tables.t_down(arguments.cos_theta, alpha, eta, tau)},
            {"R10", tables.r_up(alpha, eta, tau)},
            {"T10", tables.t_up(alpha, eta, tau)},
            {"variance", tables.variance(alpha, eta, tau)},
            {"FGD", tables.fgd_dielectric(arguments.cos_theta, alpha, eta)}};
}

std::vector<Row> simulate(const InterfaceArguments& arguments) {
    const simulator::Facets facets{arguments.ndf == "ggx" ? Ndf::ggx : Ndf::beckmann,
                                   arguments.alpha, arguments.alpha};
    simulator::RunOptions options;
    options.samples = arguments.samples;
    options.seed = arguments.seed;
    const auto result = simulator::estimate_interface(facets, arguments.eta, arguments.tau,
                                                      arguments.cos_theta, options);
    const auto row = [](const char* name, const simulator::Estimate& estimate) {
        return Row{name, estimate.mean, estimate.standard_error};
    };
    return {row("T01", result.t_down), row("R10", result.r_up), row("T10", result.t_up),
            row("variance", result.variance), row("FGD", result.fgd)};
}

void print(const std::vector<Row>& rows, bool simulated, bool as_json) {
    if (as_json) {
        nlohmann::ordered_json json;
        for (const Row& row : rows) json[row.name] = row.value;
        if (simulated)
            for (const Row& row : rows) json["stderr"][row.name] = row.standard_error;
        fmt::print("{}\n", json.dump(2));
        return;
    }
    for (const Row& row : rows) {
        fmt::print("{:<9} {:.6f}", row.name, row.value);
        if (simulated) fmt::print("  +- {:.6f}", row.standard_error);
        fmt::print("\n");
    }
}

void run(const InterfaceArguments& arguments) {
    const bool simulated = arguments.method == "simulate";
    print(simulated ? simulate(arguments) : look_up(arguments), simulated, arguments.json);
}

}  // namespace

void add_interface_command(CLI::App& app) {
    auto arguments = std::make_shared<InterfaceArguments>();
    CLI::App* command =
        app.add_subcommand("interface", "Energies of one rough dielectric interface");
    const auto number = [&](const char* flag, double& value, const char* help, double low,
                            double high) {
        command->add_option(flag, value, help)->check(CLI::Range(low, high))->required();
    };
    number("--alpha", arguments->alpha, "Slope roughness", 0.0, 1.0);
    // Written as 0.333... by people.
    number("--eta", arguments->eta, "Index below over index above, 1/3 to 3", 0.3333, 3.0);
    number("--tau", arguments->tau, "Transmittance of the medium below, along its normal", 0.0,
           1.0);
    number("--cos", arguments->cos_theta, "Cosine of the direction of light above", 1e-6, 1.0);
    command->add_option("--ndf", arguments->ndf, "ggx or beckmann [ggx]")
        ->check(CLI::IsMember({"ggx", "beckmann"}));
    command->add_option("--method", arguments->method, "table or simulate [table]")
        ->check(CLI::IsMember({"table", "simulate"}));
    command->add_option("--samples", arguments->samples, "Walks to simulate [1000000]")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 40));
    command->add_option("--seed", arguments->seed, "Seed of the walks [1]");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace lacquer
