// Functions of a cosine as polynomials of degree 3, from some cosine on to 1, through values at the
// zeros of T_4(2 x - 1), x in [0, 1] over that range.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace lacquer::reference {

inline constexpr std::size_t kCubicNodes = 4;

// Where values are known, rising; in (least, 1).
double cubic_node(std::size_t n, double least);

// What the values at the nodes count for at x; together 1.
std::array<double, kCubicNodes> cubic_weights(double x);

template <typename Value>
struct Cubic {
    std::array<Value, kCubicNodes> known{};
    double least = 0.0;  // cosine in [0, 1), below which all is as there

    Value at(double cosine) const {
        const auto weights = cubic_weights(std::max<double>(cosine - least, 0) / (1.0 - least));
        Value sum{0.0};
        for (std::size_t n = 0; n < kCubicNodes; ++n) sum += known[n] * weights[n];
        return sum;
    }
};

}  // namespace lacquer::reference
