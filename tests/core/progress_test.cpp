#include "core/progress.h"

#include <gmock/gmock.h>

namespace lacquer {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

TEST(DurationText, UsesTheTwoLargestUnits) {
    EXPECT_EQ(duration_text(0.2), "0 s");
    EXPECT_EQ(duration_text(59.4), "59 s");
    EXPECT_EQ(duration_text(125.0), "2 min 05 s");
    EXPECT_EQ(duration_text(3720.0), "1 h 02 min");
}

TEST(DurationText, NeverGoesBelowZero) {
    EXPECT_EQ(duration_text(-5.0), "0 s");
}

TEST(ProgressLine, GuessesTheRestFromThePaceSoFar) {
    // A quarter of the work took 10 s: the other three quarters take 30 s.
    const std::string line = progress_line("work", 25, 100, 10.0, "", 100);
    EXPECT_THAT(line, HasSubstr("25 %"));
    EXPECT_THAT(line, HasSubstr("30 s left"));
}

TEST(ProgressLine, SaysNothingOfTheRestBeforeTheFirstStepAndAfterTheLast) {
    EXPECT_THAT(progress_line("work", 0, 10, 3.0, "", 100), Not(HasSubstr("left")));
    EXPECT_THAT(progress_line("work", 10, 10, 3.0, "", 100), Not(HasSubstr("left")));
}

TEST(ProgressLine, ShowsTheWholeOfNoWorkAsDone) {
    EXPECT_THAT(progress_line("work", 0, 0, 0.0, "", 100), HasSubstr("100 %"));
}

TEST(ProgressLine, NeverRoundsUpToDone) {
    EXPECT_THAT(progress_line("work", 999, 1000, 1.0, "", 100), HasSubstr(" 99 %"));
}

TEST(ProgressLine, FitsTheWidth) {
    EXPECT_EQ(progress_line("work", 1, 2, 1.0, std::string(200, 'x'), 60).size(), 60u);
}

}  // namespace
}  // namespace lacquer
