// Belcour's TIR over (cos_theta, alpha, eta): what a smooth interface lets through of a lobe.
// Based on: Belcour 2018, Eqs. 32-33
#include "bake/low_rank.h"
#include "bake/mirror.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 20, kEtas = 20, kCosines = 49, kTerms = 10;

std::vector<Axis> axes_of(Contrast contrast) {
    return {alpha_axis(kAlphas), eta_axis(contrast, kEtas), profile_axis(kCosines)};
}

void simulate_node(Contrast contrast, const Parameters& node, const Walks& walks,
                   std::uint64_t seed, std::span<float> values) {
    const std::vector<double> transmittances = walks.lobe_transmittances(
        profile_cosines(kCosines, contrast, node[1]), node[0], node[1], seed);
    for (std::size_t n = 0; n < kCosines; ++n) values[n] = static_cast<float>(transmittances[n]);
}

}  // namespace

TableBake bake_of_tir() {
    std::vector<Quantity> quantities;
    for (const Contrast contrast : {Contrast::thin, Contrast::dense})
        quantities.push_back({contrast == Contrast::thin ? "tir_thin" : "tir_dense",
                              axes_of(contrast), 2,
                              [contrast](const Parameters& node, const Walks& walks,
                                         std::uint64_t seed, std::span<float> values) {
                                  simulate_node(contrast, node, walks, seed, values);
                              },
                              [contrast](const EnergyTables& tables, const Parameters& p) {
                                  const double cosine = profile_cosine(p[2], contrast, p[1]);
                                  return tables.tir(cosine, p[0], p[1]);
                              }});
    return {
        "tir", "mean transmittance of a smooth interface over a GGX lobe", quantities,
        [](const std::vector<DenseValues>& dense) {
            std::vector<TableArray> arrays;
            append_factors("thin_", "profile", axes_of(Contrast::thin), dense[0], kTerms, arrays);
            append_factors("dense_", "profile", axes_of(Contrast::dense), dense[1], kTerms, arrays);
            return arrays;
        }};
}

}  // namespace lacquer::bake
