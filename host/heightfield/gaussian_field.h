// Random surfaces whose heights are Gaussian, with the autocorrelation exp(-r^2 / length^2).
// Based on: Heitz 2015, Generating Procedural Beckmann Surfaces
#pragma once

#include <vector>

#include "simulator/random.h"

namespace lacquer::heightfield {

// A periodic grid of cells x cells heights. One surface sampled more finely is one with more
// `cells` and as many more `cells_per_length`; their ratio, the period in correlation lengths,
// stays.
struct FieldGrid {
    int cells = 512;                 // along each side, kMinCells to kMaxCells
    double cells_per_length = 16.0;  // at least kMinCellsPerLength

    double period_lengths() const { return cells / cells_per_length; }
};

inline constexpr int kMinCells = 32;
inline constexpr int kMaxCells = 4096;
// With fewer, the spectrum does not fit on the grid.
inline constexpr double kMinCellsPerLength = 4.0;
// With fewer, the surface is no random one: it meets its own copies.
inline constexpr double kMinPeriodLengths = 4.0;

// Throws Error naming the value and its range.
void require_grid(const FieldGrid& grid);

// Heights of mean 0 and variance 1 over all surfaces, row by row along x. Draws the same numbers
// for grids of the same period, which then sample the same surface.
std::vector<double> gaussian_field(const FieldGrid& grid, simulator::RandomStream& random);

// Variance of the difference of two neighbours along a row or a column, over all surfaces: exact,
// for the period, the cells and the missing mean. About 2 / cells_per_length^2.
double step_variance(const FieldGrid& grid);

}  // namespace lacquer::heightfield
