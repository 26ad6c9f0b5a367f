// Random heights: Gaussian, of the autocorrelation that Beckmann facets need.
#include "heightfield/gaussian_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "simulator/estimator.h"
#include "support/expect_fit.h"
#include "support/normal.h"

namespace lacquer::heightfield {
namespace {

using simulator::RandomStream;

constexpr double kPi = std::numbers::pi;
constexpr double kSignificance = 0.001;  // of each statistical test of this file

// A period of 8 correlation lengths.
constexpr FieldGrid kSmall{64, 8.0};

std::size_t place(int column, int row) {
    return static_cast<std::size_t>(row * kSmall.cells + column);
}

// Beckmann's distribution is that of Gaussian slopes: their squared length is exponential, their
// azimuth uniform. Slopes are taken 8 / 3 correlation lengths apart, where they are correlated by
// 0.011 at most; both slopes of one facet are by 1 / (2 * 8^2).
TEST(GaussianField, SlopesOfFacetsFollowBeckmann) {
    constexpr int kSurfaces = 2000, kPerAxis = 3, kRings = 12, kSectors = 8;
    const double scale = std::sqrt(step_variance(kSmall));
    std::vector<double> observed(kRings * kSectors);
    for (int surface = 0; surface < kSurfaces; ++surface) {
        RandomStream random{1, static_cast<std::uint64_t>(surface)};
        const std::vector<double> heights = gaussian_field(kSmall, random);
        for (int j = 0; j < kPerAxis; ++j)
            for (int i = 0; i < kPerAxis; ++i) {
                const int column = i * kSmall.cells / kPerAxis, row = j * kSmall.cells / kPerAxis;
                const double here = heights[place(column, row)];
                const double x = (heights[place(column + 1, row)] - here) / scale;
                const double y = (heights[place(column, row + 1)] - here) / scale;
                const double ring = 1.0 - std::exp(-0.5 * (x * x + y * y));
                const double sector = 0.5 + 0.5 * std::atan2(y, x) / kPi;
                ++observed[static_cast<std::size_t>(
                    std::min(int(ring * kRings), kRings - 1) * kSectors +
                    std::min(int(sector * kSectors), kSectors - 1))];
            }
    }
    const std::vector<double> expected(
        observed.size(), double(kSurfaces * kPerAxis * kPerAxis) / double(observed.size()));
    lacquer::test::expect_fit(observed, expected, kSignificance, "slopes of a Gaussian field");
}

// By Poisson's summation the missing mean takes pi / period^2 of the variance.
double missing_mean(const FieldGrid& grid) {
    return kPi / (grid.period_lengths() * grid.period_lengths());
}

TEST(GaussianField, NeighboursDifferAsTheAutocorrelationSays) {
    for (const FieldGrid& grid : {kSmall, FieldGrid{512, 16.0}, FieldGrid{100, 4.5}}) {
        const double length = grid.cells_per_length;
        const double expected =
            2.0 * (1.0 - std::exp(-1.0 / (length * length))) / (1.0 - missing_mean(grid));
        EXPECT_NEAR(step_variance(grid) / expected, 1.0, 1e-9) << grid.cells;
    }
}

TEST(GaussianField, AutocorrelationIsGaussian) {
    constexpr int kSurfaces = 600;
    for (const auto& [x, y] : {std::pair{0, 0}, {8, 0}, {0, 8}, {4, 4}, {12, -6}}) {
        simulator::Moments product;
        for (int surface = 0; surface < kSurfaces; ++surface) {
            RandomStream random{2, static_cast<std::uint64_t>(surface)};
            const std::vector<double> heights = gaussian_field(kSmall, random);
            product.add(heights[place(20, 20)] * heights[place(20 + x, 20 + y)]);
        }
        const double lengths2 = (x * x + y * y) / 64.0;
        const double missing = missing_mean(kSmall);
        EXPECT_NEAR(product.mean(kSurfaces), (std::exp(-lengths2) - missing) / (1.0 - missing),
                    lacquer::test::two_sided_z(kSignificance) * product.standard_error(kSurfaces))
            << x << " " << y;
    }
}

TEST(GaussianField, AFinerGridSamplesTheSameSurface) {
    const FieldGrid fine{2 * kSmall.cells, 2.0 * kSmall.cells_per_length};
    RandomStream random{3, 0}, again{3, 0};
    const std::vector<double> coarse_heights = gaussian_field(kSmall, random);
    const std::vector<double> fine_heights = gaussian_field(fine, again);
    for (int row = 0; row < kSmall.cells; ++row)
        for (int column = 0; column < kSmall.cells; ++column)
            EXPECT_NEAR(fine_heights[static_cast<std::size_t>(2 * row * fine.cells + 2 * column)],
                        coarse_heights[place(column, row)], 1e-12);
}

TEST(GaussianField, GridsOutOfRangeAreRefused) {
    for (const FieldGrid& grid : {FieldGrid{31, 4.0}, FieldGrid{4097, 16.0}, FieldGrid{512, 3.9},
                                  FieldGrid{512, 129.0}, FieldGrid{512, std::nan("")}}) {
        RandomStream random{1, 1};
        EXPECT_THROW(gaussian_field(grid, random), Error);
        EXPECT_THROW(step_variance(grid), Error);
    }
}

}  // namespace
}  // namespace lacquer::heightfield
