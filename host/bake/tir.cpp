// Belcour's TIR over (cos_theta, alpha, eta): what a smooth interface lets through of a lobe.
// Based on: Belcour 2018, Eqs. 32-33
#include "bake/low_rank.h"
#include "bake/mirror.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 20, kEtas = 20, kCosines = 49, kTerms = 10;

void simulate_node(Contrast contrast, const Parameters& node, const SobolPoints& points,
                   std::uint64_t seed, std::span<float> values) {
    const Axis cosines = profile_axis(kCosines);
    for (std::size_t n = 0; n < kCosines; ++n) {
        const double cosine = profile_cosine(axis_value(cosines, n), contrast, node[1]);
        values[n] = static_cast<float>(
            lobe_transmittance(cosine, node[0], node[1], points, mix_bits(seed + n)));
    }
}

void append_arrays(const std::string& prefix, Contrast contrast, const DenseValues& dense,
                   std::vector<TableArray>& arrays) {
    const Matrix values = to_matrix(dense, kCosines);
    const Matrix profile = principal_rows(values, kTerms);
    const Axis terms = channel_axis("profile", kTerms);
    arrays.push_back(make_array(prefix + "maps",
                                {alpha_axis(kAlphas), eta_axis(contrast, kEtas), terms},
                                values * profile.transpose()));
    arrays.push_back(
        make_array(prefix + "profile", {profile_axis(kCosines), terms}, profile.transpose()));
}

}  // namespace

TableBake bake_of_tir() {
    std::vector<Quantity> quantities;
    for (const Contrast contrast : {Contrast::thin, Contrast::dense})
        quantities.push_back(
            {contrast == Contrast::thin ? "tir_thin" : "tir_dense",
             {alpha_axis(kAlphas), eta_axis(contrast, kEtas), profile_axis(kCosines)},
             2,
             [contrast](const Parameters& node, const SobolPoints& points, std::uint64_t seed,
                        std::span<float> values) {
                 simulate_node(contrast, node, points, seed, values);
             },
             [contrast](const EnergyTables& tables, const Parameters& p) {
                 const double cosine = profile_cosine(p[2], contrast, p[1]);
                 return tables.tir(cosine, p[0], p[1]);
             }});
    return {"tir", "mean transmittance of a smooth interface over a GGX lobe", quantities,
            [](const std::vector<DenseValues>& dense) {
                std::vector<TableArray> arrays;
                append_arrays("thin_", Contrast::thin, dense[0], arrays);
                append_arrays("dense_", Contrast::dense, dense[1], arrays);
                return arrays;
            }};
}

}  // namespace lacquer::bake
