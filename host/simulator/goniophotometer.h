// Where the light goes: the distribution over outgoing directions of each class of light.
#pragma once

#include <cstdint>
#include <vector>

#include "simulator/rgb_estimate.h"
#include "simulator/stack.h"

namespace lacquer::simulator {

// Cells of equal solid angle on a hemisphere: rows of equal |cos_theta| from grazing to the normal,
// columns of equal azimuth from +x.
struct HemisphereGrid {
    int rows = 32;
    int columns = 64;

    std::size_t cell_count() const { return static_cast<std::size_t>(rows * columns); }
    std::size_t cell(const Vec3& w) const;  // w unit, to either side
};

// Of light that leaves to one hemisphere, all relative to the light that arrived. Mean and variance
// are those of the direction projected to the disk, (x, y) = sin_theta (cos_phi, sin_phi), weighted
// by what the light carries: a Lambertian surface has mean 0 and variance 0.25 per axis. Both are 0
// where there is no light.
struct Distribution {
    RgbEstimate energy;
    RgbEstimate mean_x, mean_y;
    RgbEstimate variance_x, variance_y;
    std::vector<RgbEstimate> cells;  // energy per cell of the grid, row by row
    std::vector<RgbEstimate> rows;   // energy per row of the grid
};

struct GoniophotometerEstimate {
    Distribution direct, base, transmitted;
    std::uint64_t samples = 0;  // walks made; fewer than asked when stopped
};

// Light that arrives along wo (unit, above the surface), by class.
GoniophotometerEstimate estimate_distribution(const StackWalk& stack, const Vec3& wo,
                                              const HemisphereGrid& grid,
                                              const RunOptions& options);

// Light that arrives along w (unit) from below a material without base; `direct` is what leaves
// above.
GoniophotometerEstimate estimate_distribution_from_below(const StackWalk& stack, const Vec3& w,
                                                         const HemisphereGrid& grid,
                                                         const RunOptions& options);

}  // namespace lacquer::simulator
