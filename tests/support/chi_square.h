// Goodness of fit of a sampler to its density.
#pragma once

#include <span>

namespace lacquer::test {

// Significance of each of `tests` tests, so that all of them together have `suite_significance`
// (Sidak's correction for independent tests).
double sidak_significance(double suite_significance, int tests);

struct ChiSquare {
    double statistic = 0.0;
    int degrees_of_freedom = 0;

    // Probability of a statistic at least this large when sampler and density agree.
    double p_value() const;
};

// Compares counts per cell with expectations. Cells expecting fewer than 5 are pooled, since the
// statistic is only asymptotically chi-square; a pool that expects next to nothing but was hit
// counts as if it expected one.
ChiSquare chi_square(std::span<const double> observed, std::span<const double> expected);

}  // namespace lacquer::test
