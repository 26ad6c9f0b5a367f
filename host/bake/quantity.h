// What is baked: each quantity over its dense grid, how it is simulated and how it is looked up.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "bake/walks.h"
#include "tables/energy_tables.h"

namespace lacquer::bake {

// Walks per node, and the seed of all walks.
struct BakeSettings {
    std::size_t samples = 1 << 14;
    std::uint64_t seed = 1;
};

// Values of the parameters in the order of a quantity's axes.
using Parameters = std::vector<double>;

// A function tabulated over a dense grid. A node is one combination of the first `node_axes` axes;
// its walks give the values along the others.
struct Quantity {
    std::string name;
    std::vector<Axis> axes;
    std::size_t node_axes = 2;

    // Simulates one node: `node` holds the parameters of the first axes.
    std::function<void(const Parameters& node, const Walks& walks, std::uint64_t seed,
                       std::span<float> values)>
        simulate;

    // The finished tables' value at a point of the grid.
    std::function<double(const EnergyTables&, const Parameters&)> look_up;

    std::size_t nodes() const;
    std::size_t values_per_node() const;
};

// Numbers on the grid of a quantity, ordered as a TableArray.
using DenseValues = std::vector<float>;

// Parameters of the node, or of the whole grid's point, of the given index.
Parameters grid_parameters(std::span<const Axis> axes, std::size_t index);

// A file and what it is made of.
struct TableBake {
    std::string name;
    std::string quantity;  // for people
    std::vector<Quantity> quantities;
    std::function<std::vector<TableArray>(const std::vector<DenseValues>&)> compress;
};

// One per name of kTableNames, in that order.
std::vector<TableBake> all_table_bakes();

TableBake bake_of_t_down(Contrast contrast);
TableBake bake_of_r_up();
TableBake bake_of_multiple();
TableBake bake_of_conductor();
TableBake bake_of_tir();
TableBake bake_of_mirror();
TableBake bake_of_lobes();

// Axes that several tables share.
Axis alpha_axis(std::size_t size);
Axis eta_axis(Contrast contrast, std::size_t size);
Axis tau_axis();
Axis profile_axis(std::size_t size);
std::vector<double> profile_cosines(std::size_t size, Contrast contrast, double eta);
Axis channel_axis(std::string name, std::size_t size);

}  // namespace lacquer::bake
