#include "reference/stack/diffuse_base.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "reference/stack/transport.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// Directions of equal weight that average T over the hemisphere.
constexpr int kDirections = 24;

// T averaged over cosine-weighted directions.
Energy mean_arriving(const StackLayers& layers) {
    Energy all{0.0};
    for (int n = 0; n < kDirections; ++n)
        all += light_from_above(layers, std::sqrt((n + 0.5) / kDirections)).down;
    return all / double{kDirections};
}

}  // namespace

DiffuseBase prepare_diffuse_base(const StackLayers& layers, const glm::dvec3& albedo) {
    const double index = layers.interfaces.back().ior_below / layers.interfaces.front().ior_above;
    // By reciprocity, what leaves of diffuse light from the base; no more than in clear media.
    const Energy leaving = glm::min(mean_arriving(layers) / (index * index), Energy{1.0});
    // Without absorption all that does not leave comes back: that keeps a white base white.
    const Energy back = diffuse_return(layers);
    const double clear_back = 1.0 - leaving.w;
    DiffuseBase base;
    for (int channel = 0; channel < 3; ++channel) {
        const double dimming = back.w > 0.0 ? std::min(back[channel] / back.w, 1.0) : 0.0;
        const double reflected = albedo[channel] / (1.0 - albedo[channel] * clear_back * dimming);
        base.spread[channel] = reflected / (pi * index * index);
        base.returned[channel] = reflected * std::min(leaving[channel], leaving.w);
    }
    return base;
}

glm::dvec3 arriving(const StackLayers& layers, double cos_theta) {
    return glm::dvec3{light_from_above(layers, cos_theta).down};
}

}  // namespace lacquer::reference
