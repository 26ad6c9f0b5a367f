#include "reference/microsurface/albedo_fit.h"

#include <cmath>
#include <numbers>

namespace lacquer::reference {

namespace {

double node_angle(std::size_t n) {
    return std::numbers::pi * (static_cast<double>(n) + 0.5) / kAlbedoNodes;
}

// The integral over x from 0 to 1 of 4 x^3 T_n(2 x - 1), what T_n counts for in an average over
// cosine-weighted directions: exact values of its monomials.
constexpr std::array<double, kAlbedoNodes> kAverages{
    1.0, 3.0 / 5.0, -1.0 / 15.0, -11.0 / 35.0, -23.0 / 105.0, -1.0 / 9.0, -1.0 / 15.0};

}  // namespace

double albedo_node_cosine(std::size_t n) {
    const double x = 0.5 + 0.5 * std::cos(node_angle(n));
    return x * x;
}

glm::dvec3 AlbedoFit::at(double cos_theta) const {
    const double x = 2.0 * std::sqrt(cos_theta) - 1.0;
    glm::dvec3 next{0.0}, after{0.0};
    for (std::size_t n = kAlbedoNodes - 1; n > 0; --n) {
        const glm::dvec3 sum = coefficients[n] + 2.0 * x * next - after;
        after = next;
        next = sum;
    }
    return coefficients[0] + x * next - after;
}

glm::dvec3 AlbedoFit::average() const {
    glm::dvec3 sum{0.0};
    for (std::size_t n = 0; n < kAlbedoNodes; ++n) sum += kAverages[n] * coefficients[n];
    return sum;
}

AlbedoFit albedo_fit(const std::array<glm::dvec3, kAlbedoNodes>& values) {
    AlbedoFit fit;
    for (std::size_t n = 0; n < kAlbedoNodes; ++n) {
        for (std::size_t node = 0; node < kAlbedoNodes; ++node)
            fit.coefficients[n] +=
                std::cos(static_cast<double>(n) * node_angle(node)) * values[node];
        fit.coefficients[n] *= (n == 0 ? 1.0 : 2.0) / kAlbedoNodes;
    }
    return fit;
}

}  // namespace lacquer::reference
