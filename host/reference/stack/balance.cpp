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

using Values = std::array<glm::dvec3, Balance::kNodes.size()>;

// What the value at each node counts for at `cosine`.
std::array<double, Balance::kNodes.size()> node_weights(double cosine) {
    const auto& nodes = Balance::kNodes;
    std::array<double, Balance::kNodes.size()> weights{1.0};
    for (std::size_t n = 1; n < nodes.size(); ++n) {
        const double way =
            std::clamp((cosine - nodes[n - 1]) / (nodes[n] - nodes[n - 1]), 0.0, 1.0);
        weights[n - 1] *= 1.0 - way;
        weights[n] = way;
    }
    return weights;
}

// The light that the lobe should have at a cosine.
glm::dvec3 wanted(const StackInterface& top, const FittedLobe& lobe, double cosine) {
    return top.entering(cosine) * glm::dvec3{lobe.at(cosine).energy};
}

// Of light at wo, the part that the lobe without b sends to wi, over the density of wi as a mirror
// image by normals visible from wo.
glm::dvec3 weight_of(const StackInterface& top, const FittedLobe& lobe, const glm::dvec3& wi,
                     const glm::dvec3& wo) {
    const LobeLight light = lobe.at(std::min(cos_theta_halfway(wi, wo), 1.0));
    return glm::dvec3{light.energy} *
           (entering_both_ways(top, wi, wo) * wi.z * reflection_lobe(facets_of(light), wi, wo) /
            reflection_pdf(facets_of(lobe.at(wo.z)), wi, wo));
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
            const glm::dvec3 weight = weight_of(top, lobe, wi, wo) / double{kAzimuths * kHeights};
            const auto nodes = node_weights(std::min(wi.z, 1.0));
            for (std::size_t n = 0; n < all.size(); ++n) all[n] += weight * nodes[n];
        }
    return all;
}

}  // namespace

double entering_both_ways(const StackInterface& top, const glm::dvec3& wi, const glm::dvec3& wo) {
    return std::sqrt(top.entering(std::min(wi.z, 1.0)) * top.entering(std::min(wo.z, 1.0)));
}

glm::dvec3 Balance::at(double cosine) const {
    const auto weights = node_weights(cosine);
    glm::dvec3 value{0.0};
    for (std::size_t n = 0; n < known.size(); ++n) value += weights[n] * known[n];
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
            glm::dvec3 albedo{0.0};
            for (std::size_t k = 0; k < last.size(); ++k) albedo += weights[n][k] * last[k];
            const glm::dvec3 light = wanted(top, lobe, Balance::kNodes[n]);
            for (int c = 0; c < 3; ++c)
                balance.known[n][c] =
                    albedo[c] > kTiny
                        ? std::clamp(std::sqrt(last[n][c] * light[c] / albedo[c]), kLeast, kMost)
                        : 1.0;
        }
    }
    return balance;
}

}  // namespace lacquer::reference
