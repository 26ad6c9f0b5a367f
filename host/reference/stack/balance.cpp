#include "reference/stack/balance.h"

#include <algorithm>
#include <cmath>

#include "reference/reflection.h"
#include "reference/shading.h"
#include "reference/stack/directions.h"

namespace lacquer::reference {

namespace {

// Points of the sampling square of visible normals, along each side; the other half of all azimuths
// mirrors this one. With 32 times as many, albedos change by 0.0003 in the mean.
constexpr int kAzimuths = 2, kHeights = 8;
constexpr int kSteps = 8;  // which find the factor to a percent
// No factor can be found where nothing enters, or all of a lobe points below the surface.
constexpr double kLeast = 0.2, kMost = 5.0;
constexpr double kTiny = 1e-9;

using Values = std::array<double, Balance::kNodes.size()>;

// What the values at the nodes count for at `cosine`.
Values weights_at(double cosine) {
    Values weights{};
    for (std::size_t n = 0; n < weights.size(); ++n) {
        Balance one{{}};
        one.known[n] = 1.0;
        weights[n] = one.at(cosine);
    }
    return weights;
}

double mean_energy(const LobeLight& light) {
    return mean(glm::dvec3{light.energy});
}

// The light that the lobe should have at a cosine.
double wanted(const StackInterface& top, const FittedLobe& lobe, double cosine) {
    return top.transmittance(cosine, true) * mean_energy(lobe.at(cosine));
}

// Of light at wo, the part that the lobe without b sends to wi, over the density of wi as a mirror
// image by normals visible from wo.
double weight_of(const StackInterface& top, const FittedLobe& lobe, const glm::dvec3& wi,
                 const glm::dvec3& wo) {
    const LobeLight light = lobe.at(std::min(cos_theta_halfway(wi, wo), 1.0));
    return entering_both_ways(top, wi, wo) * mean_energy(light) * wi.z *
           reflection_lobe(facets_of(light), wi, wo) /
           reflection_pdf(facets_of(lobe.at(wo.z)), wi, wo);
}

// The albedo at `cosine`, over b there, as a sum over the nodes of b.
Values albedo_weights(const StackInterface& top, const FittedLobe& lobe, double cosine) {
    const glm::dvec3 wo = direction_of(cosine);
    const Facets facets = facets_of(lobe.at(cosine));
    Values all{};
    for (int azimuth = 0; azimuth < kAzimuths; ++azimuth)
        for (int height = 0; height < kHeights; ++height) {
            const glm::dvec2 u{0.5 * (azimuth + 0.5) / kAzimuths, (height + 0.5) / kHeights};
            const glm::dvec3 wi = reflection_sample(facets, wo, u);
            if (!is_above(wi)) continue;
            const double weight = weight_of(top, lobe, wi, wo) / (kAzimuths * kHeights);
            const Values nodes = weights_at(std::min(wi.z, 1.0));
            for (std::size_t n = 0; n < all.size(); ++n) all[n] += weight * nodes[n];
        }
    return all;
}

}  // namespace

double entering_both_ways(const StackInterface& top, const glm::dvec3& wi, const glm::dvec3& wo) {
    return std::sqrt(top.transmittance(std::min(wi.z, 1.0), true) *
                     top.transmittance(std::min(wo.z, 1.0), true));
}

double Balance::at(double cosine) const {
    double value = known.front();
    for (std::size_t n = 1; n < known.size(); ++n)
        value += (known[n] - known[n - 1]) *
                 std::clamp((cosine - kNodes[n - 1]) / (kNodes[n] - kNodes[n - 1]), 0.0, 1.0);
    return value;
}

// By alternating scaling, as matrices are made doubly stochastic (Sinkhorn 1964), half a step at a
// time, in logarithms.
Balance fit_balance(const StackInterface& top, const FittedLobe& lobe) {
    std::array<Values, Balance::kNodes.size()> weights;
    std::ranges::transform(Balance::kNodes, weights.begin(),
                           [&](double cosine) { return albedo_weights(top, lobe, cosine); });
    Balance balance;
    for (int step = 0; step < kSteps; ++step) {
        const Values last = balance.known;
        for (std::size_t n = 0; n < last.size(); ++n) {
            double albedo = 0.0;
            for (std::size_t k = 0; k < last.size(); ++k) albedo += weights[n][k] * last[k];
            const double light = wanted(top, lobe, Balance::kNodes[n]);
            balance.known[n] = albedo > kTiny
                                   ? std::clamp(std::sqrt(last[n] * light / albedo), kLeast, kMost)
                                   : 1.0;
        }
    }
    return balance;
}

}  // namespace lacquer::reference
