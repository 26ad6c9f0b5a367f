#include "reference/stack/cubic.h"

#include <cmath>
#include <numbers>

namespace lacquer::reference {

namespace {

using Nodes = std::array<double, kCubicNodes>;

const Nodes& nodes() {
    static const Nodes all = [] {
        Nodes zeros;
        for (std::size_t n = 0; n < kCubicNodes; ++n)
            zeros[n] = 0.5 - 0.5 * std::cos((static_cast<double>(n) + 0.5) * std::numbers::pi /
                                            kCubicNodes);
        return zeros;
    }();
    return all;
}

// 1 at node n and 0 at the others.
double lagrange(std::size_t n, double x) {
    const Nodes& at = nodes();
    double product = 1.0;
    for (std::size_t k = 0; k < kCubicNodes; ++k)
        if (k != n) product *= (x - at[k]) / (at[n] - at[k]);
    return product;
}

}  // namespace

double cubic_node(std::size_t n, double least) {
    return least + (1.0 - least) * nodes()[n];
}

std::array<double, kCubicNodes> cubic_weights(double x) {
    std::array<double, kCubicNodes> weights{};
    for (std::size_t n = 0; n < kCubicNodes; ++n) weights[n] = lagrange(n, x);
    return weights;
}

}  // namespace lacquer::reference
