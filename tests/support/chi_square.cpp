#include "support/chi_square.h"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/complement.hpp>
#include <cmath>

namespace lacquer::test {

double sidak_significance(double suite_significance, int tests) {
    return 1.0 - std::pow(1.0 - suite_significance, 1.0 / tests);
}

double ChiSquare::p_value() const {
    if (degrees_of_freedom <= 0) return 1.0;
    const boost::math::chi_squared distribution(degrees_of_freedom);
    return boost::math::cdf(boost::math::complement(distribution, statistic));
}

ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected) {
    constexpr double kMinExpected = 5.0;
    ChiSquare result;
    const auto add = [&result](double seen, double wanted) {
        const double difference = seen - wanted;
        result.statistic += difference * difference / std::max(wanted, 1.0);
        ++result.degrees_of_freedom;
    };
    double pooled_observed = 0.0;
    double pooled_expected = 0.0;
    for (std::size_t cell = 0; cell < observed.size(); ++cell) {
        if (expected[cell] >= kMinExpected) {
            add(observed[cell], expected[cell]);
        } else {
            pooled_observed += observed[cell];
            pooled_expected += expected[cell];
        }
    }
    if (pooled_expected >= kMinExpected || pooled_observed > 0.0)
        add(pooled_observed, pooled_expected);
    --result.degrees_of_freedom;  // the total is given
    return result;
}

}  // namespace lacquer::test
