// The incomplete beta function between two heights against closed forms and against quadrature.
#include "reference/microsurface/incomplete_beta.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <random>

namespace lacquer::reference {
namespace {

constexpr double kRelativeError = 1e-11;

// A power of a rounded number, per unit of its exponent.
constexpr double kPowerError = 4e-15;

void expect_close(double value, double expected, double lambda, const std::string& what) {
    EXPECT_NEAR(value, expected, (kRelativeError + kPowerError * lambda) * expected) << what;
}

TEST(IncompleteBeta, OfWholeHeightIsTheBetaFunction) {
    for (const double a : {0.0, 0.3, 2.0, 40.0})
        for (const double b : {0.0, 0.1, 5.0, 90.0})
            expect_close(
                beta_between(0.0, 1.0, a, b),
                std::exp(std::lgamma(1.0 + a) + std::lgamma(1.0 + b) - std::lgamma(2.0 + a + b)),
                a + b, std::to_string(a) + " " + std::to_string(b));
}

// One lambda alone is a power, however large it is.
TEST(IncompleteBeta, WithOneLambdaIsAPower) {
    for (const double lambda : {0.0, 1e-3, 1.0, 100.0, 300.0, 1e4, 1e7})
        for (const auto& [low, high] : {std::pair{0.0, 0.5}, {0.0, 1.0}, {0.3, 0.7}, {0.9, 1.0}}) {
            const std::string what = std::to_string(lambda) + " from " + std::to_string(low);
            const double n = 1.0 + lambda;
            const double upwards = high * -std::expm1(n * std::log(low / high)) / n;
            expect_close(beta_between(low, high, lambda, 0.0), upwards, lambda, what + " upwards");
            const double downwards =
                (1.0 - low) * -std::expm1(n * std::log((1.0 - high) / (1.0 - low))) / n;
            expect_close(beta_between(low, high, 0.0, lambda), downwards, lambda,
                         what + " downwards");
        }
}

TEST(IncompleteBeta, IsItsIntegral) {
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 61>;
    std::mt19937_64 generator{17};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    for (int n = 0; n < 200; ++n) {
        const double low = n % 3 == 0 ? 0.0 : 0.9 * uniform(generator);
        const double high = n % 3 == 1 ? 1.0 : low + (1.0 - low) * uniform(generator);
        // To both sides of where the function is computed otherwise.
        const double a = std::pow(10.0, 5.0 * uniform(generator) - 2.0);
        const double b = std::pow(10.0, 5.0 * uniform(generator) - 2.0);
        // Points crowd at both ends, where one of the powers may be like a root.
        const auto integrand = [&](double t) {
            const double c = low + (high - low) * t * t * (3.0 - 2.0 * t);
            return 6.0 * t * (1.0 - t) * (high - low) * std::pow(c / high, a) *
                   std::pow(std::max(1.0 - c, 0.0) / (1.0 - low), b);
        };
        const double expected = Quadrature::integrate(integrand, 0.0, 1.0, 20, 1e-13);
        expect_close(beta_between(low, high, a, b), expected, a + b,
                     std::to_string(low) + " to " + std::to_string(high) + ", lambdas " +
                         std::to_string(a) + " " + std::to_string(b));
    }
}

}  // namespace
}  // namespace lacquer::reference
