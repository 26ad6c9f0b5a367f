#include "compare/compare.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <sstream>

#include "compare/fake_backend.h"

namespace lacquer {
namespace {

using namespace test;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Compare, PassesABackendThatAgrees) {
    const CompareResult result = run_compare(small_request({&kRight}));
    ASSERT_THAT(result.backends, SizeIs(1));
    EXPECT_EQ(result.backends[0].status, Status::passed);
    EXPECT_EQ(result.backends[0].max_rel(), 0.0);
    EXPECT_THAT(failures(result), IsEmpty());
}

TEST(Compare, FailsABackendForOneWrongQueryAndNamesAllThree) {
    const CompareRequest request = small_request({&kRight, &kWrong});
    const CompareResult result = run_compare(request);
    EXPECT_EQ(result.backends[0].status, Status::passed);
    EXPECT_EQ(result.backends[1].status, Status::failed);
    EXPECT_TRUE(result.backends[1].materials[0].passed);
    EXPECT_FALSE(result.backends[1].materials[1].passed);
    const std::vector<std::string> lines = failures(result);
    ASSERT_THAT(lines, SizeIs(1));
    const Query broken = query_of(request.grids[0], 7);
    EXPECT_THAT(lines[0], AllOf(HasSubstr("'wrong'"), HasSubstr("'second'"),
                                HasSubstr(exact_text(broken.wi)), HasSubstr("f_g")));
}

TEST(Compare, MeasuresTheBrokenQuery) {
    const CompareResult result = run_compare(small_request({&kWrong}));
    const ErrorSummary& errors = result.backends[0].materials[1].errors;
    EXPECT_NEAR(errors.max_rel, 1e-3, 1e-12);
    EXPECT_EQ(errors.median_rel, 0.0);
}

TEST(Compare, FailsWhatIsNotANumber) {
    const CompareResult result = run_compare(small_request({&kNotANumber}));
    EXPECT_EQ(result.backends[0].status, Status::failed);
    EXPECT_THAT(result.backends[0].reason, HasSubstr("not finite"));
}

TEST(Compare, FailsABackendThatIsImpreciseEverywhere) {
    const CompareResult result = run_compare(small_request({&kImprecise}));
    EXPECT_LT(result.backends[0].max_rel(), kFloatTolerance.max_rel);
    EXPECT_EQ(result.backends[0].status, Status::failed);
    EXPECT_THAT(result.backends[0].reason, HasSubstr("median"));
}

TEST(Compare, SkipsABackendThatCannotRunAndSaysWhy) {
    const CompareResult result = run_compare(small_request({&kMissing, &kRight}));
    EXPECT_EQ(result.backends[0].status, Status::skipped);
    EXPECT_THAT(result.backends[0].reason,
                AllOf(HasSubstr("no driver <here>"), HasSubstr("install one")));
    EXPECT_EQ(result.backends[1].status, Status::passed);
    EXPECT_THAT(failures(result), IsEmpty());
}

TEST(Compare, FailsABackendThatBreaksDownAndGoesOn) {
    const CompareResult result = run_compare(small_request({&kCrashing, &kRight}));
    EXPECT_EQ(result.backends[0].status, Status::failed);
    EXPECT_EQ(result.backends[1].status, Status::passed);
    const std::vector<std::string> lines = failures(result);
    ASSERT_THAT(lines, SizeIs(1));
    EXPECT_THAT(lines[0], AllOf(HasSubstr("crashing"), HasSubstr("the device was lost")));
}

TEST(Compare, CountsQueriesAndTheirRate) {
    const CompareRequest request = small_request({&kRight});
    const std::size_t queries = request.grids[0].query_count() + request.grids[1].query_count();
    const CompareResult result = run_compare(request);
    EXPECT_EQ(result.backends[0].materials[0].errors.queries, queries);
    // Two materials over both grids, half a second each.
    EXPECT_DOUBLE_EQ(result.backends[0].queries_per_second, 2.0 * double(queries) / 1.0);
}

TEST(Compare, TakesAsManyStepsAsItSays) {
    CompareRequest request = small_request({&kRight, &kWrong});
    std::size_t steps = 0;
    request.on_step = [&](std::string_view) { ++steps; };
    run_compare(request);
    EXPECT_EQ(steps, step_count(request));
}

TEST(ExactText, ReadsBackAsTheSameFloats) {
    const glm::vec3 w{1.0f / 3.0f, -0.1f, 1e-7f};
    std::istringstream text{exact_text(w)};
    for (int axis = 0; axis < 3; ++axis) {
        std::string number;
        std::getline(text, number, ',');
        EXPECT_EQ(std::strtof(number.c_str(), nullptr), w[axis]);
    }
}

}  // namespace
}  // namespace lacquer
