#include "reference/stack/diffuse_base.h"

#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "reference/stack/transport.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// Directions of equal weight that average T over the hemisphere.
constexpr int kDirections = 12;

// Where T is known: the zeros of T_4(2 c - 1).
double known_cosine(std::size_t n) {
    return 0.5 - 0.5 * std::cos((static_cast<double>(n) + 0.5) * pi / 4.0);
}

// 1 at known_cosine(n) and 0 at the others.
double lagrange(std::size_t n, double cosine) {
    double product = 1.0;
    for (std::size_t k = 0; k < ArrivingLight::kKnown; ++k)
        if (k != n) product *= (cosine - known_cosine(k)) / (known_cosine(n) - known_cosine(k));
    return product;
}

}  // namespace

Energy ArrivingLight::at(double cosine) const {
    Energy share{0.0};
    for (std::size_t n = 0; n < kKnown; ++n) share += known[n] * lagrange(n, cosine);
    return top.transmittance(cosine, true) * glm::clamp(share, Energy{0.0}, Energy{1.0});
}

Energy ArrivingLight::average() const {
    Energy all{0.0};
    for (int n = 0; n < kDirections; ++n) all += at(std::sqrt((n + 0.5) / kDirections));
    return all / double{kDirections};
}

ArrivingLight fit_arriving(const StackLayers& layers) {
    ArrivingLight fit{layers.interfaces.front(), {}};
    for (std::size_t n = 0; n < ArrivingLight::kKnown; ++n)
        fit.known[n] = light_of_entered(layers, known_cosine(n)).arrived();
    return fit;
}

DiffuseBase prepare_diffuse_base(const StackLayers& layers, const glm::dvec3& albedo) {
    const double index = layers.interfaces.back().ior_below / layers.interfaces.front().ior_above;
    DiffuseBase base{fit_arriving(layers), {}, {}};
    // By reciprocity, what leaves of diffuse light from the base; no more than in clear media.
    const Energy leaving = glm::min(base.arriving.average() / (index * index), Energy{1.0});
    // Without absorption all that does not leave comes back: that keeps a white base white.
    const Energy back = diffuse_return(layers);
    const double clear_back = 1.0 - leaving.w;
    for (int channel = 0; channel < 3; ++channel) {
        const double dimming = back.w > 0.0 ? std::min(back[channel] / back.w, 1.0) : 0.0;
        const double reflected = albedo[channel] / (1.0 - albedo[channel] * clear_back * dimming);
        base.spread[channel] = reflected / (pi * index * index);
        base.returned[channel] = reflected * std::min(leaving[channel], leaving.w);
    }
    return base;
}

}  // namespace lacquer::reference
