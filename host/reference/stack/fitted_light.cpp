#include "reference/stack/fitted_light.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "reference/shading.h"
#include "reference/stack/directions.h"
#include "reference/stack/lobe_width.h"

namespace lacquer::reference {

namespace {

// Less is as good as none: its width hangs on the last digits.
constexpr double kLeastLight = 1e-12;

double sine_of(double cosine) {
    return direction_of(cosine).x;
}

LobeLight all_of(const Beam& beam) {
    return {beam.energy(), width_of_alpha(beam.alpha())};
}

// The nearest node towards the normal that has light, where n has none.
std::size_t next_with_light(std::size_t n, const std::array<LobeLight, kCubicNodes>& known) {
    while (n + 1 < kCubicNodes && sum(known[n].energy) <= kLeastLight) ++n;
    return n;
}

double least_entering_cosine(const StackInterface& top) {
    const double eta = top.eta(true);
    return std::max(std::sqrt(std::max(1.0 - eta * eta, 0.0)) - top.greatest_alpha(), 0.0);
}

}  // namespace

EnteredLight entered_light(const StackLayers& layers) {
    EnteredLight light{least_entering_cosine(layers.interfaces.front()), {}};
    for (std::size_t n = 0; n < kCubicNodes; ++n)
        light.known[n] = light_of_entered(layers, cubic_node(n, light.least));
    return light;
}

Facets facets_of(const LobeLight& light) {
    const double alpha = std::clamp(alpha_of_width(light.width), kMinAlpha, 1.0);
    return {Ndf::ggx, alpha, alpha};
}

bool FittedLobe::is_dark() const {
    return std::ranges::all_of(energy.known, [](const Energy& e) { return sum(e) <= 0.0; });
}

LobeLight FittedLobe::at(double cosine) const {
    return {glm::clamp(energy.at(cosine), Energy{0.0}, Energy{1.0}),
            width_of_alpha(std::clamp(alpha.at(cosine), narrowest, widest))};
}

FittedLobe fit_lobe(const std::array<LobeLight, kCubicNodes>& known, double least) {
    FittedLobe fit;
    fit.energy.least = fit.alpha.least = least;
    for (std::size_t n = 0; n < kCubicNodes; ++n) {
        const std::size_t lit = next_with_light(n, known);
        fit.energy.known[n] = known[n].energy;
        fit.alpha.known[n] = alpha_of_width(known[lit].width);
    }
    const auto [narrowest, widest] = std::ranges::minmax(fit.alpha.known);
    fit.narrowest = narrowest;
    fit.widest = widest;
    return fit;
}

Beam FittedBeam::at(double cosine) const {
    Beam beam;
    beam.through = lobe.at(cosine);
    const double sine = std::clamp(sine_ratio.at(cosine) * sine_of(cosine), 0.0, kMostSine);
    beam.cosine = std::sqrt(1.0 - sine * sine);
    return beam;
}

FittedBeam fit_beam(const std::array<Beam, kCubicNodes>& known, double least) {
    FittedBeam fit;
    fit.sine_ratio.least = least;
    std::array<LobeLight, kCubicNodes> lobes;
    std::ranges::transform(known, lobes.begin(), all_of);
    fit.lobe = fit_lobe(lobes, least);
    for (std::size_t n = 0; n < kCubicNodes; ++n) {
        const std::size_t lit = next_with_light(n, lobes);
        fit.sine_ratio.known[n] = sine_of(known[lit].cosine) / sine_of(cubic_node(lit, least));
    }
    return fit;
}

}  // namespace lacquer::reference
