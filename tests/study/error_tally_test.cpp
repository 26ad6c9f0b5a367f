#include "study/error_tally.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace lacquer::study {
namespace {

TEST(ErrorTally, KeepsMeanLargestAndItsPlace) {
    ErrorTally tally{"subject", "model"};
    tally.add(-0.3, 0.0, [] { return "left"; });
    tally.add(0.1, 0.0, [] { return "right"; });
    const ModelError error = tally.result();
    EXPECT_DOUBLE_EQ(error.mean, 0.2);
    EXPECT_DOUBLE_EQ(error.max, 0.3);
    EXPECT_DOUBLE_EQ(error.noise, 0.0);
    EXPECT_EQ(error.where, "left");
}

TEST(ErrorTally, ExpectsTheMeanSizeOfNormalNoise) {
    ErrorTally tally{"subject", "model"};
    tally.add(0.0, 2.0, [] { return ""; });
    EXPECT_DOUBLE_EQ(tally.result().noise, 2.0 * std::sqrt(2.0 / std::numbers::pi));
}

TEST(ErrorTally, LeavesOutOfTheLargestWhatMayBeNoise) {
    ErrorTally tally{"subject", "model", 3.0};
    tally.add(1.0, 0.5, [] { return "noisy"; });
    tally.add(0.4, 0.1, [] { return "sure"; });
    EXPECT_NEAR(tally.result().max, 0.1, 1e-12);
    EXPECT_EQ(tally.result().where, "sure");
}

TEST(ErrorTally, IsZeroBeforeAnythingIsAdded) {
    const ModelError error = ErrorTally{"subject", "model"}.result();
    EXPECT_EQ(error.mean, 0.0);
    EXPECT_EQ(error.max, 0.0);
}

}  // namespace
}  // namespace lacquer::study
