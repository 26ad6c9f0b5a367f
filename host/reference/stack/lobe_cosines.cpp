#include "reference/stack/lobe_cosines.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "reference/facets.h"
#include "reference/shading.h"

namespace lacquer::reference {

namespace {

// Nearer to grazing hardly a facet is seen that mirrors light upwards.
constexpr double kLeastCosine = 0.014;

// Equal parts of cosine-weighted directions.
void add_diffuse(LobeCosines& lobe, double weight) {
    constexpr double kParts = LobeCosines::kDiffuse;
    for (std::size_t n = 0; n < LobeCosines::kDiffuse; ++n)
        lobe.add(std::sqrt((static_cast<double>(n) + 0.5) / kParts), 0.0, weight / kParts);
}

}  // namespace

void LobeCosines::add(double cosine, double sine, double weight) {
    cosines[count] = cosine;
    sines[count] = sine;
    weights[count] = weight;
    ++count;
}

void LobePart::add(const LobeCosines& lobe, std::size_t n, double factor) {
    const double part = lobe.weights[n] * factor;
    light_ += part;
    cosine_ += part * lobe.cosines[n];
    sine_ += part * lobe.sines[n];
    square_ += part * (1.0 - lobe.cosines[n] * lobe.cosines[n]);
}

double LobePart::spread() const {
    const double mean = sine_ / light_;
    return std::max(square_ / light_ - mean * mean, 0.0);
}

LobeCosines lobe_cosines(const LobeShape& shape) {
    LobeCosines lobe;
    const double alpha = alpha_of_variance(shape.variance);
    if (alpha < kMinAlpha) {
        lobe.add(cosine_of(shape), shape.sine, 1.0);
        return lobe;
    }
    const glm::dvec3 w = direction_of(std::max(cosine_of(shape), kLeastCosine));
    const Facets facets{Ndf::ggx, alpha, alpha};
    double mirrored = 0.0;
    for (const glm::dvec3& wm : visible_facets(w, alpha)) {
        const glm::dvec3 wr = 2.0 * glm::dot(w, wm) * wm - w;
        if (wr.z <= 0.0) continue;
        // Of what w sees, wr sees G2 / G1.
        const double weight = masking_shadowing(facets, w, wr) / masking(facets, w) /
                              static_cast<double>(std::tuple_size_v<VisibleFacets>);
        lobe.add(wr.z, -wr.x, weight);
        mirrored += weight;
    }
    add_diffuse(lobe, 1.0 - mirrored);
    return lobe;
}

LobeCosines diffuse_cosines() {
    LobeCosines lobe;
    add_diffuse(lobe, 1.0);
    return lobe;
}

}  // namespace lacquer::reference
