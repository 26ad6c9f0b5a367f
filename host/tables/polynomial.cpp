#include "tables/polynomial.h"

#include <cmath>

namespace lacquer {

namespace {

// Clenshaw's recurrence.
double chebyshev_sum(const Coefficients& coefficients, double x) {
    double next = 0.0, after = 0.0;
    for (std::size_t n = kCoefficients; n-- > 1;) {
        const double current = 2.0 * x * next - after + coefficients[n];
        after = next;
        next = current;
    }
    return x * next - after + coefficients[0];
}

// Coefficients of the powers of t of T_n(2 t - 1).
using Powers = std::array<double, kCoefficients>;

std::array<Powers, kCoefficients> shifted_chebyshev() {
    std::array<Powers, kCoefficients> polynomials{};
    polynomials[0][0] = 1.0;
    polynomials[1] = {-1.0, 2.0};
    for (std::size_t n = 2; n < kCoefficients; ++n)
        for (std::size_t p = 0; p < kCoefficients; ++p) {
            const double shifted = p > 0 ? polynomials[n - 1][p - 1] : 0.0;
            polynomials[n][p] = 4.0 * shifted - 2.0 * polynomials[n - 1][p] - polynomials[n - 2][p];
        }
    return polynomials;
}

}  // namespace

const MomentTable& chebyshev_moments() {
    static const MomentTable table = [] {
        const auto polynomials = shifted_chebyshev();
        MomentTable moments{};
        for (std::size_t n = 0; n < kCoefficients; ++n)
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t p = 0; p < kCoefficients; ++p)
                    moments[n][j] += 2.0 * polynomials[n][p] / static_cast<double>(p + 2 * j + 2);
        return moments;
    }();
    return table;
}

double DirectionPolynomial::at(double cos_theta) const {
    if (cos_theta < critical)
        return chebyshev_sum(below, 1.0 - 2.0 * std::sqrt((critical - cos_theta) / critical));
    return chebyshev_sum(above, 2.0 * std::sqrt((cos_theta - critical) / (1.0 - critical)) - 1.0);
}

double DirectionPolynomial::energy() const {
    const double c = critical, rest = 1.0 - critical;
    double sum = 0.0, sign = 1.0;  // T_n(-x) = sign T_n(x)
    for (std::size_t n = 0; n < kCoefficients; ++n, sign = -sign) {
        const auto& j = chebyshev_moments()[n];
        sum += below[n] * sign * c * c * (j[0] - j[1]);
        sum += above[n] * rest * (c * j[0] + rest * j[1]);
    }
    return sum;
}

double DirectionPolynomial::spread() const {
    const double c = critical, rest = 1.0 - critical;
    double sum = 0.0, sign = 1.0;
    for (std::size_t n = 0; n < kCoefficients; ++n, sign = -sign) {
        const auto& j = chebyshev_moments()[n];
        sum += below[n] * sign * c * c * c * c * (j[0] - 3.0 * j[1] + 3.0 * j[2] - j[3]);
        sum += above[n] * rest *
               (c * c * c * j[0] + 3.0 * c * c * rest * j[1] + 3.0 * c * rest * rest * j[2] +
                rest * rest * rest * j[3]);
    }
    return sum;
}

}  // namespace lacquer
