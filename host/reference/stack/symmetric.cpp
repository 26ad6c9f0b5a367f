#include "reference/stack/symmetric.h"

#include <algorithm>
#include <glm/common.hpp>

#include "reference/reflection.h"

namespace lacquer::reference {

namespace {

constexpr double kTinyLight = 1e-30;  // keeps quotients of nothing finite

double entering(const StackInterface& top, double cosine) {
    return top.entering(cosine);
}

template <typename Light, typename Take>
std::array<Light, kCubicNodes> taken(const EnteredLight& entered, const Take& take) {
    std::array<Light, kCubicNodes> lights;
    std::ranges::transform(entered.known, lights.begin(), take);
    return lights;
}

SymmetricLobe symmetric_lobe(const StackInterface& top,
                             const std::array<LobeLight, kCubicNodes>& known, double least) {
    SymmetricLobe lobe{fit_lobe(known, least), {}};
    if (!lobe.light.is_dark()) lobe.balance = fit_balance(top, lobe.light);
    return lobe;
}

}  // namespace

StackLight SymmetricLight::at(double cosine) const {
    const double share = entering(top, cosine);
    StackLight light{1.0 - share, interfaces.light.at(cosine), base.light.at(cosine),
                     straight.at(cosine), detoured.at(cosine)};
    light.interfaces.energy *= share;
    light.base.energy *= share;
    light.straight.scale(Energy{share});
    light.detoured.scale(Energy{share});
    // What comes through is no more than what has entered and was not reflected, which cubics know
    // apart from it.
    const Energy room =
        glm::max(Energy{share} - light.interfaces.energy - light.base.energy, Energy{0.0});
    const Energy within =
        glm::min(room / glm::max(light.arrived(), Energy{kTinyLight}), Energy{1.0});
    light.straight.scale(within);
    light.detoured.scale(within);
    return light;
}

SymmetricLight fit_symmetric(const StackLayers& layers, const EnteredLight& entered) {
    const StackInterface& top = layers.interfaces.front();
    using Of = const StackLight&;
    const auto lobe = [&](const auto& take) {
        return symmetric_lobe(top, taken<LobeLight>(entered, take), entered.least);
    };
    const auto beam = [&](const auto& take) {
        return fit_beam(taken<Beam>(entered, take), entered.least);
    };
    return {top, lobe([](Of light) { return light.interfaces; }),
            lobe([](Of light) { return light.base; }),
            beam([](Of light) { return light.straight; }),
            beam([](Of light) { return light.detoured; })};
}

glm::dvec3 symmetric_value(const SymmetricLight& light, const glm::dvec3& wi,
                           const glm::dvec3& wo) {
    const double cosine = std::min(cos_theta_halfway(wi, wo), 1.0);
    glm::dvec3 f{0.0};
    for (const SymmetricLobe* lobe : {&light.interfaces, &light.base}) {
        if (lobe->light.is_dark()) continue;
        const LobeLight here = lobe->light.at(cosine);
        const glm::dvec3 scale =
            lobe->balance.at(std::min(wi.z, 1.0)) * lobe->balance.at(std::min(wo.z, 1.0));
        f += glm::dvec3{here.energy} * scale * reflection_lobe(facets_of(here), wi, wo);
    }
    return entering_both_ways(light.top, wi, wo) * f;
}

}  // namespace lacquer::reference
