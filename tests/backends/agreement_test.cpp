// Every backend that runs here computes what the reference computes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "backends/jobs.h"
#include "backends/truth.h"

namespace lacquer::test {
namespace {

// Float has 24 bits: a formula of a hundred operations keeps about 5 digits in the worst place and
// nearly 7 in the middle. The same figures as those of `lacquer compare`.
constexpr double kMaxRelativeError = 1e-4;
constexpr double kMedianRelativeError = 3e-7;

// Below this an error counts in absolute terms.
constexpr double kSmallValue = 1e-3;

double relative_error(double value, double expected) {
    return std::abs(value - expected) / std::max(std::abs(expected), kSmallValue);
}

void expect_agreement(const Rows& rows, const Rows& expected) {
    ASSERT_EQ(rows.size(), expected.size());
    std::vector<double> errors;
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (int c = 0; c < 4; ++c) {
            errors.push_back(relative_error(rows[i][c], expected[i][c]));
            // Written so that NaN fails, too.
            ASSERT_TRUE(errors.back() <= kMaxRelativeError)
                << fmt::format("row {} component {}: {}, expected {}, relative error {}", i, c,
                               rows[i][c], expected[i][c], errors.back());
        }
    std::ranges::nth_element(errors, errors.begin() + errors.size() / 2);
    EXPECT_LE(errors[errors.size() / 2], kMedianRelativeError);
}

class BackendAgreement : public ::testing::TestWithParam<std::tuple<std::string, Kernel>> {};

TEST_P(BackendAgreement, WithTheReference) {
    const auto& [name, kernel] = GetParam();
    std::string skipped;
    const auto backend = create_or_explain(name, skipped);
    if (!backend) GTEST_SKIP() << skipped;
    // An albedo is hundreds of evaluations.
    const std::uint64_t queries_per_material = kernel == Kernel::albedo ? 64 : 4096;
    const OwnedJob owned = make_job(kernel, test_materials(), queries_per_material);
    const JobResult result = backend->run(owned.job());
    EXPECT_GT(result.seconds, 0.0);
    expect_agreement(result.rows, expected_rows(owned.job(), result.rows));
}

std::string test_name(const ::testing::TestParamInfo<BackendAgreement::ParamType>& test) {
    std::string name = std::get<0>(test.param);
    std::ranges::replace(name, '-', '_');
    return fmt::format("{}_{}", name, kernel_shape(std::get<1>(test.param)).name);
}

INSTANTIATE_TEST_SUITE_P(Every, BackendAgreement,
                         ::testing::Combine(::testing::ValuesIn(shader_backends()),
                                            ::testing::ValuesIn(kAllKernels)),
                         test_name);

}  // namespace
}  // namespace lacquer::test
