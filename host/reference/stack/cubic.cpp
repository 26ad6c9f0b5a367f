#include "reference/stack/cubic.h"

#include <cmath>
#include <numbers>

namespace lacquer::reference {

namespace {

// 1 at cubic_node(n) and 0 at the others.
double lagrange(std::size_t n, double cosine) {
    double product = 1.0;
    for (std::size_t k = 0; k < kCubicNodes; ++k)
        if (k != n) product *= (cosine - cubic_node(k)) / (cubic_node(n) - cubic_node(k));
    return product;
}

}  // namespace

double cubic_node(std::size_t n) {
    return 0.5 - 0.5 * std::cos((static_cast<double>(n) + 0.5) * std::numbers::pi / kCubicNodes);
}

std::array<double, kCubicNodes> cubic_weights(double cosine) {
    std::array<double, kCubicNodes> weights{};
    for (std::size_t n = 0; n < kCubicNodes; ++n) weights[n] = lagrange(n, cosine);
    return weights;
}

}  // namespace lacquer::reference
