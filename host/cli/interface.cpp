// `lacquer interface`: the energies of one rough dielectric interface over an absorbing medium.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>

#include "cli/commands.h"
#include "cli/options.h"
#include "cli/simulate_options.h"
#include "core/error.h"
#include "core/paths.h"
#include "core/table.h"
#include "simulator/interface.h"
#include "tables/energy_tables.h"

namespace lacquer {

namespace {

constexpr std::int64_t kDefaultWalks = 1'000'000;

constexpr const char* kTableMethod = "table";

constexpr const char* kSummary = "Energies of one rough dielectric interface";

constexpr const char* kHelp =
    R"(Prints what one rough interface over an absorbing medium does to light: of light that arrives at
--cos, `T01` enters and crosses the medium, `FGD` is reflected. Of diffuse light from inside that
crosses the medium upwards, `R10` is reflected and crosses it again, `T10` leaves, spread by
`variance` per axis of the projected disk. They come from the baked tables, or by simulation, which
adds standard errors. Ctrl-C ends a simulation and prints what it found so far.

Examples:
  lacquer interface --alpha 0.3 --eta 1.5 --tau 0.8 --cos 0.7
  lacquer interface --alpha 0.3 --eta 1.5 --tau 0.8 --cos 0.7 --method simulate --json)";

struct Arguments {
    double alpha = 0.0, eta = 1.5, tau = 1.0, cos_theta = 1.0;
    std::string ndf = "ggx";
    std::string method = kTableMethod;
    SimulateOptions simulate;
    bool json = false;
};

// A value and, where it was simulated, its standard error.
struct Quantity {
    std::string name;
    double value = 0.0;
    double standard_error = 0.0;
};

struct Result {
    std::vector<Quantity> quantities;
    std::uint64_t walks = 0;  // 0 for values of the tables
};

Result look_up(const Arguments& arguments) {
    if (arguments.ndf != "ggx")
        throw UsageError{fmt::format("--ndf: the tables are of ggx facets; {} takes --method {}",
                                     arguments.ndf, kSimulateMethod)};
    const EnergyTables tables{share_folder() / "tables"};
    const auto [alpha, eta, tau] = std::array{arguments.alpha, arguments.eta, arguments.tau};
    return {{{"T01", tables.t_down(arguments.cos_theta, alpha, eta, tau)},
             {"R10", tables.r_up(alpha, eta, tau)},
             {"T10", tables.t_up(alpha, eta, tau)},
             {"variance", tables.variance(alpha, eta, tau)},
             {"FGD", tables.fgd_dielectric(arguments.cos_theta, alpha, eta)}}};
}

Result simulate(const Arguments& arguments) {
    const simulator::Facets facets{arguments.ndf == "ggx" ? Ndf::ggx : Ndf::beckmann,
                                   arguments.alpha, arguments.alpha};
    const std::uint64_t walks = walk_count(arguments.simulate, kDefaultWalks);
    SimulationRun run{walks};
    const auto result =
        simulator::estimate_interface(facets, arguments.eta, arguments.tau, arguments.cos_theta,
                                      run.next(walks, arguments.simulate.seed));
    const auto quantity = [](const char* name, const simulator::Estimate& estimate) {
        return Quantity{name, estimate.mean, estimate.standard_error};
    };
    return {
        {quantity("T01", result.t_down), quantity("R10", result.r_up), quantity("T10", result.t_up),
         quantity("variance", result.variance), quantity("FGD", result.fgd)},
        result.samples};
}

std::string table_text(const Result& result) {
    std::vector<Column> columns{{"quantity"}, {"value", Align::right}};
    if (result.walks > 0) columns.push_back({"standard error", Align::right});
    std::vector<std::vector<std::string>> cells;
    for (const Quantity& quantity : result.quantities) {
        cells.push_back({quantity.name, fmt::format("{:.6f}", quantity.value)});
        if (result.walks > 0)
            cells.back().push_back(fmt::format("{:.6f}", quantity.standard_error));
    }
    return format_table(columns, cells);
}

std::string json_text(const Result& result) {
    nlohmann::ordered_json json;
    for (const Quantity& quantity : result.quantities) json[quantity.name] = quantity.value;
    if (result.walks > 0) {
        for (const Quantity& quantity : result.quantities)
            json["stderr"][quantity.name] = quantity.standard_error;
        json["samples"] = result.walks;
    }
    return json.dump(2) + "\n";
}

void run(const CLI::App& command, const Arguments& arguments) {
    require_range("--alpha", arguments.alpha, 0.0, 1.0);
    require_range("--eta", arguments.eta, kMinTableEta, kMaxTableEta);
    require_range("--tau", arguments.tau, 0.0, 1.0);
    require_range("--cos", arguments.cos_theta, 0.0, 1.0);
    require_method(
        command, arguments.method,
        std::array{Method{kTableMethod, {}}, Method{kSimulateMethod, {"--samples", "--seed"}}});
    const Result result =
        arguments.method == kSimulateMethod ? simulate(arguments) : look_up(arguments);
    print_data(arguments.json ? json_text(result) : table_text(result));
}

}  // namespace

void add_interface_command(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App* command = app.add_subcommand("interface", kSummary)->footer(kHelp);
    const auto number = [command](const char* flag, double& value, const char* help) {
        command->add_option(flag, value, help)->required();
    };
    number("--alpha", arguments->alpha, "Slope roughness, 0 to 1");
    number("--eta", arguments->eta, "Index below over index above, 1/3 to 3");
    number("--tau", arguments->tau, "Transmittance of the medium along the normal, 0 to 1");
    number("--cos", arguments->cos_theta, "Cosine of the angle of the light above, 0 to 1");
    command->add_option("--ndf", arguments->ndf, "Distribution of the facets: ggx or beckmann")
        ->check(CLI::IsMember({"ggx", "beckmann"}))
        ->capture_default_str();
    command->add_option("--method", arguments->method, "How: table or simulate")
        ->capture_default_str();
    add_walk_options(*command, arguments->simulate, "Walks of a simulation (default 1000000)");
    command->add_flag("--json", arguments->json, "Print JSON");
    command->callback([command, arguments] { run(*command, *arguments); });
}

}  // namespace lacquer
