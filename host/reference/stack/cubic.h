// Functions of a cosine as polynomials of degree 3, through values at the zeros of T_4(2 c - 1).
#pragma once

#include <array>
#include <cstddef>

namespace lacquer::reference {

inline constexpr std::size_t kCubicNodes = 4;

// Where values are known, rising; in (0, 1).
double cubic_node(std::size_t n);

// What the values at the nodes count for at `cosine`; together 1.
std::array<double, kCubicNodes> cubic_weights(double cosine);

template <typename Value>
struct Cubic {
    std::array<Value, kCubicNodes> known{};

    Value at(double cosine) const {
        const auto weights = cubic_weights(cosine);
        Value sum{0.0};
        for (std::size_t n = 0; n < kCubicNodes; ++n) sum += known[n] * weights[n];
        return sum;
    }
};

}  // namespace lacquer::reference
