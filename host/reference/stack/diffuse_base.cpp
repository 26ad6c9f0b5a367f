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

}  // namespace

Energy ArrivingLight::at(double cosine) const {
    return top.entering(cosine) * glm::clamp(share.at(cosine), Energy{0.0}, Energy{1.0});
}

Energy ArrivingLight::average() const {
    Energy all{0.0};
    for (int n = 0; n < kDirections; ++n) all += at(std::sqrt((n + 0.5) / kDirections));
    return all / double{kDirections};
}

DiffuseBase prepare_diffuse_base(const StackLayers& layers, const EnteredLight& entered,
                                 const glm::dvec3& albedo) {
    const double index = layers.interfaces.back().ior_below / layers.interfaces.front().ior_above;
    DiffuseBase base{{layers.interfaces.front(), {}}, {}, {}};
    base.arriving.share.least = entered.least;
    for (std::size_t n = 0; n < kCubicNodes; ++n)
        base.arriving.share.known[n] = entered.known[n].arrived();
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
