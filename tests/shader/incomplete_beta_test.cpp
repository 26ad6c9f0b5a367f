// lq_beta_between against the reference's incomplete beta function, which is Boost's.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "reference/microsurface/incomplete_beta.h"
#include "shader.h"

namespace lacquer::test {
namespace {

using shader::Real;

// The greatest relative error over random heights at least 0.05 apart, many from 0 or to 1, for
// Lambdas up to `most_up` and `most_down`, small ones as often as large ones.
double greatest_error(double most_up, double most_down) {
    std::mt19937_64 generator{20230806};
    std::uniform_real_distribution<Real> uniform{0, 1};
    double greatest = 0.0;
    for (int n = 0; n < 20000; ++n) {
        Real low = n % 3 == 0 ? Real{0} : uniform(generator);
        Real high = n % 3 == 1 ? Real{1} : uniform(generator);
        if (high < low) std::swap(low, high);
        if (high - low < Real(0.05)) continue;
        const Real share_up = uniform(generator), share_down = uniform(generator);
        const Real up = static_cast<Real>(most_up) * share_up * share_up * share_up;
        const Real down = static_cast<Real>(most_down) * share_down * share_down * share_down;
        const double expected = reference::beta_between(low, high, up, down);
        const double found = shader::lq_beta_between(low, high, up, down);
        greatest = std::max<double>(greatest, std::abs(found / expected - 1.0));
    }
    return greatest;
}

TEST(ShaderIncompleteBeta, HasFiveDigitsAwayFromGrazing) {
    EXPECT_LE(greatest_error(20.0, 20.0), 1e-5);
}

// Of one direction near grazing light arrives, but of both hardly any.
TEST(ShaderIncompleteBeta, HasFourDigitsWhereOneDirectionIsGrazing) {
    EXPECT_LE(greatest_error(1e3, 2.0), 1e-4);
    EXPECT_LE(greatest_error(2.0, 1e3), 1e-4);
}

TEST(ShaderIncompleteBeta, IsFiniteForTheGreatestLambdas) {
    const Real most = shader::LQ_MAX_BETA_LAMBDA;
    for (const auto& [up, down] : {std::pair{most, Real{0}}, {Real{0}, most}, {most, most}}) {
        const Real value = shader::lq_beta_between(Real{0}, Real{1}, up, down);
        EXPECT_GE(value, 0.0);
        EXPECT_LE(value, 1.0);
    }
}

}  // namespace
}  // namespace lacquer::test
