// Stretching heights: strata keep their shares, slopes are scaled, the surface stays whole.
#include "heightfield/stretch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "core/error.h"
#include "simulator/random.h"

namespace lacquer::heightfield {
namespace {

constexpr int kHeights = 1000;

std::vector<double> random_heights() {
    simulator::RandomStream random{1, 0};
    std::vector<double> heights;
    for (int n = 0; n < kHeights; ++n) heights.push_back(std::log(random.uniform()));
    return heights;
}

const std::vector<StretchedStratum> kThree{{0.2, 0.5}, {0.5, 2.0}, {0.3, 0.0}};

TEST(Stretch, EachStratumHasItsShareOfTheHeights) {
    const std::vector<double> heights = random_heights();
    const Stretch stretch{kThree, heights};
    std::array<int, 3> counts{};
    for (const double height : heights) ++counts[stretch.stratum(height)];
    for (std::size_t n = 0; n < counts.size(); ++n)
        EXPECT_EQ(counts[n], std::lround(kThree[n].weight * kHeights)) << n;
}

TEST(Stretch, SlopesAreScaledByEachStratumAndNothingBreaks) {
    const Stretch stretch{kThree, random_heights()};
    ASSERT_EQ(stretch.boundaries().size(), 2u);
    EXPECT_GT(stretch.boundaries()[0], stretch.boundaries()[1]);
    for (const double boundary : stretch.boundaries())
        EXPECT_NEAR(stretch(boundary + 1e-9), stretch(boundary - 1e-9), 1e-8);
    constexpr double kStep = 1e-6;
    for (double height = -5.0; height < 0.0; height += 0.0137) {
        const std::size_t stratum = stretch.stratum(height);
        if (stratum != stretch.stratum(height + kStep)) continue;
        EXPECT_NEAR((stretch(height + kStep) - stretch(height)) / kStep, kThree[stratum].factor,
                    1e-6)
            << height;
    }
}

TEST(Stretch, OneStratumScalesAll) {
    const std::vector<StretchedStratum> one{{1.0, 3.0}};
    const Stretch stretch{one, random_heights()};
    EXPECT_EQ(stretch(0.5), 1.5);
    EXPECT_EQ(stretch.stratum(-100.0), 0u);
}

TEST(Stretch, AStratumWithoutHeightsIsRefused) {
    const std::vector<StretchedStratum> top{{1e-4, 1.0}, {1.0 - 1e-4, 2.0}};
    const std::vector<StretchedStratum> bottom{{1.0 - 1e-4, 1.0}, {1e-4, 2.0}};
    EXPECT_THROW((Stretch{top, random_heights()}), Error);
    EXPECT_THROW((Stretch{bottom, random_heights()}), Error);
}

}  // namespace
}  // namespace lacquer::heightfield
