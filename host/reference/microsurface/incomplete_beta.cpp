#include "reference/microsurface/incomplete_beta.h"

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/math/special_functions/beta.hpp>
#include <cmath>

namespace lacquer::reference {

namespace {

// Beyond this logarithm of 1 / the divisors the function may be below the smallest double.
constexpr double kMaxLogScale = 300.0;

constexpr double kTolerance = 1e-13;

// Where most of the function lies below both heights the difference of complements keeps its
// digits.
double difference(double low, double high, double a, double b) {
    using boost::math::beta;
    using boost::math::betac;
    if (low <= 0.0) return high >= 1.0 ? beta(a, b) : beta(a, b, high);
    if (high >= 1.0) return betac(a, b, low);
    const double mean = a / (a + b);
    return low > mean ? betac(a, b, low) - betac(a, b, high) : beta(a, b, high) - beta(a, b, low);
}

// Of an integrand with one peak, which falls off from there within any part of the range: the
// points of this rule crowd at the ends of both intervals.
double by_quadrature(double low, double high, double lambda_above, double lambda_below) {
    thread_local boost::math::quadrature::tanh_sinh<double> rule;  // makes its points on demand
    const auto integrand = [&](double c) {
        return std::pow(c / high, lambda_above) * std::pow((1.0 - c) / (1.0 - low), lambda_below);
    };
    const double peak = std::clamp(lambda_above / (lambda_above + lambda_below), low, high);
    double sum = 0.0;
    if (peak > low) sum += rule.integrate(integrand, low, peak, kTolerance);
    if (peak < high) sum += rule.integrate(integrand, peak, high, kTolerance);
    return sum;
}

}  // namespace

double beta_between(double low, double high, double lambda_above, double lambda_below) {
    const double log_scale = -lambda_above * std::log(high) - lambda_below * std::log1p(-low);
    // The complete beta function may be as small as 2 to the power of minus both lambdas.
    if (log_scale + lambda_above + lambda_below > kMaxLogScale)
        return by_quadrature(low, high, lambda_above, lambda_below);
    return std::exp(log_scale) * difference(low, high, 1.0 + lambda_above, 1.0 + lambda_below);
}

}  // namespace lacquer::reference
