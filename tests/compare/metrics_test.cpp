#include "compare/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace lacquer {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(QueryError, TakesTheLargestOfTheComponents) {
    // Relative errors 0.5/2, 1/10, 0.3/1; absolute 0.5, 1, 0.3.
    const QueryError error = query_error({2.5, 11.0, 0.7, 99.0}, {2.0, 10.0, 1.0, 0.0}, 3);
    EXPECT_DOUBLE_EQ(error.absolute, 1.0);
    EXPECT_DOUBLE_EQ(error.relative, 0.3);
    EXPECT_EQ(error.component, 2);
}

TEST(QueryError, MeasuresSmallValuesAgainstTheFloor) {
    const QueryError error = query_error({3e-6, 0, 0, 0}, {1e-6, 0, 0, 0}, 4);
    EXPECT_DOUBLE_EQ(error.relative, 2e-6 / kRelativeFloor);
}

TEST(QueryError, IsZeroForEqualRows) {
    const QueryError error = query_error({1, 2, 3, 4}, {1, 2, 3, 4}, 4);
    EXPECT_EQ(error.absolute, 0.0);
    EXPECT_EQ(error.relative, 0.0);
}

TEST(QueryError, IsInfiniteWhereEitherSideIsNotFinite) {
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        EXPECT_EQ(query_error({1, bad, 1, 1}, {1, 1, 1, 1}, 4).relative, kInfinity);
        EXPECT_EQ(query_error({1, 1, 1, 1}, {1, bad, 1, 1}, 4).relative, kInfinity);
        EXPECT_EQ(query_error({1, bad, 1, 1}, {1, bad, 1, 1}, 4).relative, kInfinity);
        EXPECT_EQ(query_error({1, bad, 1, 1}, {1, 1, 1, 1}, 4).component, 1);
    }
}

TEST(QueryError, IgnoresComponentsThatAreNotCompared) {
    EXPECT_EQ(query_error({1, 1, 1, kNan}, {1, 1, 1, 0}, 3).relative, 0.0);
}

TEST(Summarize, MeetsHandComputedValues) {
    // 1000 errors: relative 1, 2, ..., 1000 in some order, absolute half of that.
    std::vector<QueryError> errors;
    for (int i = 0; i < 1000; ++i) {
        const double value = 1 + i * 7 % 1000;
        errors.push_back({value / 2, value, 0});
    }
    const ErrorSummary summary = summarize(errors);
    EXPECT_EQ(summary.queries, 1000u);
    EXPECT_DOUBLE_EQ(summary.max_abs, 500.0);
    EXPECT_DOUBLE_EQ(summary.mean_abs, 1001.0 / 4.0);
    EXPECT_DOUBLE_EQ(summary.max_rel, 1000.0);
    EXPECT_DOUBLE_EQ(summary.p999_rel, 999.0);
    EXPECT_DOUBLE_EQ(summary.median_rel, 500.0);
    EXPECT_DOUBLE_EQ(errors[summary.worst].relative, 1000.0);
}

TEST(Summarize, OfOneQueryIsThatQuery) {
    const ErrorSummary summary = summarize(std::vector<QueryError>{{0.5, 0.25, 0}});
    EXPECT_EQ(summary.max_rel, 0.25);
    EXPECT_EQ(summary.p999_rel, 0.25);
    EXPECT_EQ(summary.median_rel, 0.25);
}

TEST(Summarize, OfNothingIsZero) {
    EXPECT_EQ(summarize({}).queries, 0u);
    EXPECT_EQ(summarize({}).max_rel, 0.0);
}

TEST(Summarize, CountsWhatIsNotFiniteAndCallsItTheWorst) {
    const ErrorSummary summary =
        summarize(std::vector<QueryError>{{1, 1, 0}, {kInfinity, kInfinity, 0}, {2, 2, 0}});
    EXPECT_EQ(summary.non_finite, 1u);
    EXPECT_EQ(summary.worst, 1u);
    EXPECT_EQ(summary.max_rel, kInfinity);
    EXPECT_EQ(summary.median_rel, 2.0);
}

}  // namespace
}  // namespace lacquer
