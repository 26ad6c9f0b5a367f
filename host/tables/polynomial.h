// Functions of direction at an interface as polynomials, so that shading evaluates them without
// reading a table, and integrates them in closed form.
//
// cos_theta = c + (1 - c) t^2 above the critical cosine c of light that enters, and c (1 - t^2)
// below it, t in [0, 1]: near c the Fresnel equations follow its square root, and so does t. To
// each side the function is a sum of Chebyshev polynomials T_n(x): x = 2 t - 1 above, x = 1 - 2 t
// below. For eta >= 1 there is no critical angle, c is 0, and all directions are above.
#pragma once

#include <array>
#include <cstddef>

namespace lacquer {

inline constexpr std::size_t kCoefficients = 8;  // to each side

using Coefficients = std::array<double, kCoefficients>;

struct DirectionPolynomial {
    double critical = 0.0;  // c
    Coefficients below{}, above{};

    // cos_theta in [0, 1].
    double at(double cos_theta) const;

    // Integral of at(cos) cos dcos over [0, 1].
    double energy() const;

    // Integral of at(cos) cos^3 dcos over [0, 1].
    double spread() const;
};

// J(n, j) = integral over t in [0, 1] of T_n(2 t - 1) 2 t^(2 j + 1) dt, at [n][j].
using MomentTable = std::array<std::array<double, 4>, kCoefficients>;
const MomentTable& chebyshev_moments();

}  // namespace lacquer
