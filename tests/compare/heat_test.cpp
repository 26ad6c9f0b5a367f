#include "report/heat.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "image/png.h"
#include "report/histogram.h"

namespace lacquer {
namespace {

TEST(HeatScale, RunsOverFourDecadesBelowTheLimit) {
    const HeatScale scale{1e-4};
    EXPECT_EQ(scale.index_of(0.0f), HeatScale::kFirstStep);
    EXPECT_EQ(scale.index_of(0.9e-8f), HeatScale::kFirstStep);
    EXPECT_EQ(scale.index_of(1.01e-6f), HeatScale::kFirstStep + 2 * HeatScale::kStepsPerDecade);
    EXPECT_EQ(scale.index_of(0.99e-4f), HeatScale::kFirstStep + HeatScale::kSteps - 1);
}

TEST(HeatScale, SetsApartWhatExceedsTheLimitAndWhatIsNotFinite) {
    const HeatScale scale{1e-4};
    EXPECT_EQ(scale.index_of(1.01e-4f), HeatScale::kOver);
    EXPECT_EQ(scale.index_of(std::numeric_limits<float>::infinity()), HeatScale::kNotFinite);
    EXPECT_EQ(scale.index_of(std::nanf("")), HeatScale::kNotFinite);
    EXPECT_EQ(scale.palette().size(), HeatScale::kNotFinite + 1u);
}

TEST(HeatPng, PlacesTilesSideBySide) {
    const QueryGrid grid = slice_grid("slice", direction_at(0.0), 8);
    const std::vector<float> small(grid.query_count(), 0.0f), large(grid.query_count(), 1.0f);
    const HeatScale scale{1e-4};
    const std::vector<HeatTile> tiles{{&grid, small}, {&grid, large}};
    const Image image = decode_png(heat_png(scale, tiles), "heat");
    ASSERT_EQ(image.width, 16);
    ASSERT_EQ(image.height, 8);
    EXPECT_EQ(image.at(0, 0).w, 0.0f);
    EXPECT_EQ(image.at(12, 4) * 255.0f, glm::vec4(kOverLimitColor.r, kOverLimitColor.g,
                                                  kOverLimitColor.b, kOverLimitColor.a));
    EXPECT_NE(image.at(4, 4), image.at(12, 4));
}

TEST(ErrorHistogram, CountsInItsBinsAndAtItsEnds) {
    ErrorHistogram histogram;
    for (const float error : {0.0f, 1e-12f, 1.01e-10f}) histogram.add(error);
    histogram.add(std::numeric_limits<float>::infinity());
    histogram.add(1.0f);
    histogram.add(1.01e-6f);
    EXPECT_DOUBLE_EQ(histogram.share(0), 3.0 / 6.0);
    EXPECT_DOUBLE_EQ(histogram.share(ErrorHistogram::kBins - 1), 2.0 / 6.0);
    EXPECT_DOUBLE_EQ(histogram.share(4 * ErrorHistogram::kBinsPerDecade), 1.0 / 6.0);
}

}  // namespace
}  // namespace lacquer
