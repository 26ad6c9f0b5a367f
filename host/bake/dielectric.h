// Light that meets a rough dielectric interface, by the direction in which it leaves: one set of
// walks serves every medium below.
#pragma once

#include <array>
#include <cstdint>

#include "bake/sequence.h"

namespace lacquer::bake {

// Light by b = sqrt(cosine) in [0, 1] of the direction that it left in, shared linearly (in the
// cosine) between the two nearest nodes.
struct CosineHistogram {
    static constexpr std::size_t kNodes = 129;
    std::array<double, kNodes> light{};

    void add(double cosine, double amount);

    // The cosine of a node.
    static double cosine(std::size_t node);

    // What is left after crossing a medium of transmittance tau in [0, 1] along its normal, `times`
    // times.
    double transmitted(double tau, double times = 1.0) const;

    void scale(double factor);
};

// Light arriving at cos_theta in [0, 1] on GGX facets of alpha in [0, 1], eta = ior below / ior
// above, that enters: one walk per point, exact for alpha 0.
CosineHistogram light_entering(double cos_theta, double alpha, double eta,
                               const SobolPoints& points, std::uint64_t node_seed);

// The part of the light that does not enter which has met more than one facet.
double light_reflected_again(double cos_theta, double alpha, double eta, const SobolPoints& points,
                             std::uint64_t node_seed);

// Diffuse light from below.
struct DiffuseExits {
    CosineHistogram left;       // by the cosine before it left
    CosineHistogram reflected;  // by the cosine whose path is as long as one up and one down
};

DiffuseExits light_leaving(double alpha, double eta, const SobolPoints& points,
                           std::uint64_t node_seed);

}  // namespace lacquer::bake
