// The model `microsurface-stochastic` in double precision: one rough surface, uniform or not, with
// light of all orders. What meets one facet is in closed form, what meets more is estimated by
// random walks: the mean over seeds is the BSDF of Smith's theory. Based on: d'Eon et al. 2023,
// Microfacet Theory for Non-Uniform Heightfields;
//           Heitz et al. 2016, Multiple-Scattering Microfacet BSDFs with the Smith Model
//
// Directions, media and f as in microsurface_single.h. The same seed gives the same value; seeds
// that differ give independent ones.
#pragma once

#include <cstdint>

#include "reference/microsurface/microsurface_single.h"

namespace lacquer::reference {

// Facets after which a walk goes on by chance alone (Russian roulette), which keeps the mean, with
// at most kMostSurvival each time.
inline constexpr int kCertainFacets = 8;
inline constexpr double kMostSurvival = 0.9;

// Facets that one walk may meet: of 10^11 walks, one meets more and loses the rest of its light.
inline constexpr int kMaxWalkFacets = 256;

// Of `sample`, the share of directions chosen evenly over all that light leaves to, for what has
// met several facets.
inline constexpr double kEvenChoice = 0.2;

// Walks that estimate an albedo.
inline constexpr std::uint32_t kAlbedoWalks = 1u << 14;

struct StochasticMicrosurface {
    SingleMicrosurface first;
};

// Throws as prepare_microsurface_single.
StochasticMicrosurface prepare_microsurface_stochastic(const Material& material);

// An estimate of f(wi, wo), per steradian. One walk starts from each of the two directions; at
// every facet beyond its first it counts what goes straight on to the other direction. A path that
// both could have walked is weighted by how likely each was to (the balance heuristic: Veach and
// Guibas 1995, Optimally Combining Sampling Techniques for Monte Carlo Rendering).
glm::dvec3 eval(const StochasticMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo,
                std::uint32_t seed);

// Density per solid angle with which `sample` chooses wi; not random, and above 0 wherever f is.
double pdf(const StochasticMicrosurface& surface, const glm::dvec3& wi, const glm::dvec3& wo);

// A direction of light for a viewer at wo, from u in [0, 1)^3, weighted by `eval` of that seed.
Sample sample(const StochasticMicrosurface& surface, const glm::dvec3& wo, const glm::dvec3& u,
              std::uint32_t seed);

// As in microsurface_single.h; of light that met several facets, the mean of kAlbedoWalks walks.
Albedo albedo(const StochasticMicrosurface& surface, const glm::dvec3& wo, std::uint32_t seed);

}  // namespace lacquer::reference
