#include "bake/walks.h"

#include <utility>

namespace lacquer::bake {

Conductors::Conductors(std::vector<Index> all)
    : indices{std::move(all)}, curves{indices.size(), [this](std::size_t material, double cosine) {
                                          const Index& index = indices[material];
                                          return conductor_reflectance(cosine, index.eta,
                                                                       index.kappa);
                                      }} {}

std::vector<CosineHistogram> HostWalks::light_entering(std::span<const double> cosines,
                                                       double alpha, double eta,
                                                       std::uint64_t seed) const {
    std::vector<CosineHistogram> entered;
    for (std::size_t n = 0; n < cosines.size(); ++n)
        entered.push_back(
            bake::light_entering(cosines[n], alpha, eta, points_, mix_bits(seed + n)));
    return entered;
}

std::vector<double> HostWalks::light_reflected_again(std::span<const double> cosines, double alpha,
                                                     double eta, std::uint64_t seed) const {
    std::vector<double> reflected;
    for (std::size_t n = 0; n < cosines.size(); ++n)
        reflected.push_back(
            bake::light_reflected_again(cosines[n], alpha, eta, points_, mix_bits(seed + n)));
    return reflected;
}

DiffuseExits HostWalks::light_leaving(double alpha, double eta, std::uint64_t seed) const {
    return bake::light_leaving(alpha, eta, points_, seed);
}

std::vector<double> HostWalks::reflected_by_conductors(double cos_theta, double alpha,
                                                       const Conductors& conductors,
                                                       std::uint64_t seed) const {
    return reflected_by_facets(cos_theta, alpha, conductors.curves, points_, seed);
}

double HostWalks::reflected_once(double cos_theta, double alpha, std::uint64_t seed) const {
    return bake::reflected_once(cos_theta, alpha, points_, seed);
}

std::vector<double> HostWalks::lobe_transmittances(std::span<const double> cosines, double alpha,
                                                   double eta, std::uint64_t seed) const {
    std::vector<double> transmittances;
    for (std::size_t n = 0; n < cosines.size(); ++n)
        transmittances.push_back(
            lobe_transmittance(cosines[n], alpha, eta, points_, mix_bits(seed + n)));
    return transmittances;
}

}  // namespace lacquer::bake
