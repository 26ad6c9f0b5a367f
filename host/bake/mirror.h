// Light that meets rough mirror facets: all orders of scattering, for many Fresnel curves at once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "bake/sequence.h"

namespace lacquer::bake {

// Fresnel reflectances over the cosine at the facet, one column per material.
class FresnelCurves {
 public:
    // `reflectance(material, cosine)` for materials 0 to count - 1.
    template <typename Reflectance>
    FresnelCurves(std::size_t count, const Reflectance& reflectance)
        : count_{count}, values_(kNodes * count) {
        for (std::size_t node = 0; node < kNodes; ++node)
            for (std::size_t n = 0; n < count; ++n)
                values_[node * count + n] = static_cast<float>(reflectance(n, cosine(node)));
    }

    std::size_t count() const { return count_; }

    // Multiplies each material's weight by its reflectance at `cosine`.
    void attenuate(double cosine, std::span<float> weights) const;

 private:
    static constexpr std::size_t kNodes = 513;  // over the square root: curves bend at grazing

    static double cosine(std::size_t node) {
        const double root = static_cast<double>(node) / (kNodes - 1);
        return root * root;
    }

    std::size_t count_;
    std::vector<float> values_;
};

// Fresnel reflectance of a smooth conductor; index 0 + 0 i reflects everything.
double conductor_reflectance(double cos_theta_i, double eta, double kappa);

// Fraction of light arriving at cos_theta in [0, 1] that GGX facets of alpha in [0, 1] reflect, per
// material.
std::vector<double> reflected_by_facets(double cos_theta, double alpha, const FresnelCurves& curves,
                                        const SobolPoints& points, std::uint64_t node_seed);

// The same for perfect mirrors and one facet only: what single-scattering models keep.
double reflected_once(double cos_theta, double alpha, const SobolPoints& points,
                      std::uint64_t node_seed);

// Mean cosine of the light that perfect mirrors make of light arriving at cos_theta: what leaves
// after one facet, and what is lost by that as diffuse light, spread over the hemisphere.
double mean_lobe_cosine(double cos_theta, double alpha, const SobolPoints& points,
                        std::uint64_t node_seed);

// Mean of 1 - F(eta) over the directions into which mirror facets reflect light arriving at
// cos_theta, first facet only.
double lobe_transmittance(double cos_theta, double alpha, double eta, const SobolPoints& points,
                          std::uint64_t node_seed);

}  // namespace lacquer::bake
