// The simulator's part of `lacquer bench`: how fast light walks through a rough interface.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lacquer/material.h"

namespace lacquer {

// Of walks that arrive at one interface between dielectrics from one direction, until they leave
// it.
struct WalkRate {
    Ndf ndf;
    double alpha;
    double walks_per_core_second;
};

// Medians over `runs` runs, on one core. Counts that core's own time, which others that share it do
// not slow down.
std::vector<WalkRate> measure_walk_rates(int runs);

std::string table_text(const std::vector<WalkRate>& rates);

nlohmann::ordered_json to_json(const std::vector<WalkRate>& rates);

}  // namespace lacquer
