#include "reference/coated_base.h"

#include <algorithm>
#include <glm/common.hpp>
#include <numbers>

#include "reference/shading.h"

namespace lacquer::reference {

namespace {

using std::numbers::pi;

// No more than a clear medium lets through, whatever the tables are off by.
glm::dvec3 transmitted(const CoatedBase& base, const glm::dvec3& w) {
    const glm::dvec3 entering{base.entering[0].at(w.z), base.entering[1].at(w.z),
                              base.entering[2].at(w.z)};
    return glm::min(entering, glm::dvec3{base.clear.at(w.z)});
}

// One lobe for all channels, so that it is one look-up into prefiltered light. It has the variance
// of all its light: each channel's weighted by its energy, since all have the same mean direction.
double variance_of_all(const CoatedBase& base) {
    double energy = 0.0;
    double spread = 0.0;
    for (int channel = 0; channel < 3; ++channel) {
        const TransmissionProfile& profile = base.entering[static_cast<std::size_t>(channel)];
        const double light = profile.average() * base.returned[channel];
        energy += light;
        spread += light * profile.variance();
    }
    return energy > 0.0 ? spread / energy : base.entering[0].variance();
}

}  // namespace

CoatedBase prepare_coated_base(const Coat& coat, const glm::dvec3& albedo, const glm::dvec3& tau,
                               BaseLobe shape, const EnergyTables& tables) {
    const auto profile = [&](int channel) {
        return tables.t_down_profile(coat.alpha, coat.eta, tau[channel]);
    };
    CoatedBase base{shape,
                    {profile(0), profile(1), profile(2)},
                    tables.t_down_profile(coat.alpha, coat.eta, 1.0),
                    {},
                    {},
                    {}};
    for (int channel = 0; channel < 3; ++channel) {
        const double trapped = albedo[channel] * tables.r_up(coat.alpha, coat.eta, tau[channel]);
        const double reflected = albedo[channel] / (1.0 - trapped);
        base.returned[channel] = reflected * tables.t_up(coat.alpha, coat.eta, tau[channel]);
        base.spread[channel] = reflected / (pi * coat.eta * coat.eta);
    }
    base.lobe = prepare_normal_lobe(variance_of_all(base), tables);
    return base;
}

glm::dvec3 base_lobe(const CoatedBase& base, const glm::dvec3& wi, const glm::dvec3& wo) {
    if (base.shape == BaseLobe::ggx) return base_albedo(base, wo) * normal_lobe(base.lobe, wi);
    return transmitted(base, wi) * transmitted(base, wo) * base.spread;
}

double base_pdf(const CoatedBase& base, const glm::dvec3& wi) {
    if (!is_above(wi)) return 0.0;
    return base.shape == BaseLobe::ggx ? normal_lobe_pdf(base.lobe, wi) : wi.z / pi;
}

glm::dvec3 base_sample(const CoatedBase& base, const glm::dvec2& u) {
    return base.shape == BaseLobe::ggx ? normal_lobe_sample(base.lobe, u) : sample_cosine(u);
}

glm::dvec3 base_albedo(const CoatedBase& base, const glm::dvec3& w) {
    return transmitted(base, w) * base.returned;
}

}  // namespace lacquer::reference
