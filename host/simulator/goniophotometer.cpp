#include "simulator/goniophotometer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lacquer::simulator {

namespace {

// Sums of weight x^k and weight^2 x^k of one projected coordinate x.
struct CoordinateMoments {
    std::array<double, 3> plain{};
    std::array<double, 5> squared{};

    void add(double weight, double x) {
        double power = weight;
        for (double& sum : plain) {
            sum += power;
            power *= x;
        }
        power = weight * weight;
        for (double& sum : squared) {
            sum += power;
            power *= x;
        }
    }

    void merge(const CoordinateMoments& other) {
        for (std::size_t k = 0; k < plain.size(); ++k) plain[k] += other.plain[k];
        for (std::size_t k = 0; k < squared.size(); ++k) squared[k] += other.squared[k];
    }

    double mean() const { return plain[1] / plain[0]; }
    double variance() const { return plain[2] / plain[0] - mean() * mean(); }

    // Both are ratios of sums; their errors to first order, from the squared residuals.
    double mean_error() const {
        const double m = mean();
        const double residual = squared[2] - 2.0 * m * squared[1] + m * m * squared[0];
        return std::sqrt(std::max(residual, 0.0)) / plain[0];
    }

    double variance_error() const {
        const double m = mean();
        const double c = m * m - variance();
        const double residual = squared[4] - 4.0 * m * squared[3] +
                                (4.0 * m * m + 2.0 * c) * squared[2] - 4.0 * m * c * squared[1] +
                                c * c * squared[0];
        return std::sqrt(std::max(residual, 0.0)) / plain[0];
    }
};

using RgbCoordinate = std::array<CoordinateMoments, 3>;

struct DistributionTally {
    RgbMoments energy;
    RgbCoordinate x, y;
    std::vector<RgbMoments> cells;  // empty as long as no light came

    void add(const HemisphereGrid& grid, const Exit& exit) {
        if (cells.empty()) cells.resize(grid.cell_count());
        cells[grid.cell(exit.direction)].add(exit.weight);
        energy.add(exit.weight);
        for (int channel = 0; channel < 3; ++channel) {
            x[static_cast<std::size_t>(channel)].add(exit.weight[channel], exit.direction.x);
            y[static_cast<std::size_t>(channel)].add(exit.weight[channel], exit.direction.y);
        }
    }

    void merge(const DistributionTally& other) {
        if (cells.empty()) cells.resize(other.cells.size());
        for (std::size_t cell = 0; cell < other.cells.size(); ++cell)
            cells[cell].merge(other.cells[cell]);
        energy.merge(other.energy);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            x[channel].merge(other.x[channel]);
            y[channel].merge(other.y[channel]);
        }
    }
};

struct GoniophotometerTally {
    DistributionTally direct, base, transmitted;
    std::uint64_t count = 0;

    void add(const HemisphereGrid& grid, const Exit& exit) {
        if (exit.fate == Fate::direct) direct.add(grid, exit);
        if (exit.fate == Fate::base) base.add(grid, exit);
        if (exit.fate == Fate::transmitted) transmitted.add(grid, exit);
    }

    void merge(const GoniophotometerTally& other) {
        direct.merge(other.direct);
        base.merge(other.base);
        transmitted.merge(other.transmitted);
    }
};

void set_coordinate(const RgbCoordinate& moments, RgbEstimate& mean, RgbEstimate& variance) {
    for (std::size_t channel = 0; channel < 3; ++channel) {
        if (moments[channel].plain[0] <= 0.0) continue;
        mean.mean[channel] = moments[channel].mean();
        mean.standard_error[channel] = moments[channel].mean_error();
        variance.mean[channel] = moments[channel].variance();
        variance.standard_error[channel] = moments[channel].variance_error();
    }
}

Distribution to_distribution(DistributionTally tally, const HemisphereGrid& grid, double count) {
    Distribution result;
    result.energy = tally.energy.estimate(count);
    set_coordinate(tally.x, result.mean_x, result.variance_x);
    set_coordinate(tally.y, result.mean_y, result.variance_y);
    tally.cells.resize(grid.cell_count());
    for (int row = 0; row < grid.rows; ++row) {
        RgbMoments whole;
        for (int column = 0; column < grid.columns; ++column) {
            const RgbMoments& cell =
                tally.cells[static_cast<std::size_t>(row * grid.columns + column)];
            result.cells.push_back(cell.estimate(count));
            whole.merge(cell);
        }
        result.rows.push_back(whole.estimate(count));
    }
    return result;
}

// Walks between two merges of tallies that hold a number per cell.
constexpr std::uint64_t kBlock = 1 << 15;

template <typename Walk>
GoniophotometerEstimate estimate(const HemisphereGrid& grid, const RunOptions& options,
                                 const Walk& walk) {
    const auto tally = run_walks<GoniophotometerTally>(
        options,
        [&](RandomStream& random, GoniophotometerTally& sum) { sum.add(grid, walk(random)); },
        kBlock);
    const auto count = static_cast<double>(tally.count);
    return {to_distribution(tally.direct, grid, count), to_distribution(tally.base, grid, count),
            to_distribution(tally.transmitted, grid, count), tally.count};
}

}  // namespace

std::size_t HemisphereGrid::cell(const Vec3& w) const {
    const double turn = std::atan2(w.y, w.x) / (2.0 * std::numbers::pi);
    const double positive_turn = turn < 0.0 ? turn + 1.0 : turn;
    const int row = std::min(static_cast<int>(std::abs(w.z) * rows), rows - 1);
    const int column = std::min(static_cast<int>(positive_turn * columns), columns - 1);
    return static_cast<std::size_t>(row * columns + column);
}

GoniophotometerEstimate estimate_distribution(const StackWalk& stack, const Vec3& wo,
                                              const HemisphereGrid& grid,
                                              const RunOptions& options) {
    return estimate(grid, options, [&](RandomStream& random) { return stack.walk(wo, random); });
}

GoniophotometerEstimate estimate_distribution_from_below(const StackWalk& stack, const Vec3& w,
                                                         const HemisphereGrid& grid,
                                                         const RunOptions& options) {
    return estimate(grid, options,
                    [&](RandomStream& random) { return stack.walk_from_below(w, random); });
}

}  // namespace lacquer::simulator
