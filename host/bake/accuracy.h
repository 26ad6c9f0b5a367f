// How far look-ups in the finished tables are from fresh simulation at random points.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bake/bake.h"
#include "tables/energy_tables.h"

namespace lacquer::bake {

struct ErrorSummary {
    double mean = 0.0, p99 = 0.0, max = 0.0;
    Parameters worst;  // where the largest error is
};

// A function of the tables, judged over its whole range.
struct Check {
    std::string name;
    std::vector<Axis> ranges;  // parameters drawn uniformly over these; eta over its logarithm
    std::function<double(const EnergyTables&, const Parameters&)> look_up;
    std::function<double(const Parameters&, const SobolPoints&, std::uint64_t seed)> simulate;
};

std::vector<Check> all_checks();

// Mean, 99th percentile and largest absolute error over `count` random points, each simulated anew
// with settings.samples walks, whose noise is part of the errors.
ErrorSummary judge_off_grid(const Check& check, const EnergyTables& tables, std::size_t count,
                            const BakeSettings& settings);

// The same over the points of dense bakes, `dense` of each quantity, every `stride`-th of them.
ErrorSummary judge_on_grid(std::span<const Quantity> quantities, std::span<const DenseValues> dense,
                           const EnergyTables& tables, std::size_t stride);

}  // namespace lacquer::bake
