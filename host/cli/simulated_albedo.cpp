#include "cli/simulated_albedo.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "cli/options.h"
#include "core/table.h"
#include "simulator/albedo.h"

namespace lacquer {

namespace {

using Json = nlohmann::ordered_json;
using simulator::AlbedoEstimate;
using simulator::RgbEstimate;

struct Row {
    double cosine;
    AlbedoEstimate albedo;
};

std::string color(const Rgb& c) {
    return fmt::format("{:.5f} {:.5f} {:.5f}", c[0], c[1], c[2]);
}

std::string error(const Rgb& c) {
    return fmt::format("{:#.2g} {:#.2g} {:#.2g}", c[0], c[1], c[2]);
}

std::string table_text(const std::vector<Row>& rows) {
    std::vector<std::vector<std::string>> cells;
    for (const auto& [cosine, albedo] : rows)
        cells.push_back({fmt::format("{}", cosine), color(albedo.direct.mean),
                         color(albedo.base.mean), color(albedo.transmitted.mean),
                         color(albedo.total.mean), error(albedo.total.standard_error)});
    return format_table({{"cos", Align::right},
                         {"direct"},
                         {"base"},
                         {"transmitted"},
                         {"total"},
                         {"standard error of total"}},
                        cells);
}

// `value` is the mean or the standard error of an estimate.
Json json_of(const AlbedoEstimate& albedo, Rgb RgbEstimate::*value, bool with_orders) {
    Json json{{"direct", albedo.direct.*value},
              {"base", albedo.base.*value},
              {"transmitted", albedo.transmitted.*value},
              {"total", albedo.total.*value}};
    if (!with_orders) return json;
    Json& orders = json["orders"];
    for (std::size_t order = 0; order < albedo.orders.size(); ++order)
        orders[std::to_string(order + 1)] = albedo.orders[order].*value;
    orders["all"] = albedo.total.*value;
    return json;
}

std::string json_text(const std::vector<Row>& rows, bool with_orders) {
    Json list = Json::array();
    for (const auto& [cosine, albedo] : rows) {
        Json row{{"cos", cosine}, {"samples", albedo.samples}};
        row.update(json_of(albedo, &RgbEstimate::mean, with_orders));
        row["stderr"] = json_of(albedo, &RgbEstimate::standard_error, with_orders);
        list.push_back(row);
    }
    return Json{{"rows", list}}.dump(2) + "\n";
}

std::vector<Row> simulated(const simulator::StackWalk& stack, const std::vector<double>& cosines,
                           std::uint64_t samples, std::int64_t seed) {
    SimulationRun run{samples * cosines.size()};
    std::vector<Row> rows;
    for (const double cosine : cosines) {
        if (run.stopped()) break;
        rows.push_back({cosine, estimate_albedo(stack, cosine, run.next(samples, seed))});
    }
    return rows;
}

}  // namespace

void print_simulated_albedo(const Material& material, const std::vector<double>& cosines,
                            std::uint64_t samples, const SimulateOptions& options, bool json) {
    const simulator::StackWalk stack{material, stack_options(options)};
    const std::vector<Row> rows = simulated(stack, cosines, samples, options.seed);
    print_data(json ? json_text(rows, stack.is_one_surface()) : table_text(rows));
}

}  // namespace lacquer
