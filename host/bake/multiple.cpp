// What a dielectric interface reflects after more than one facet, over (cos_theta, alpha, eta): the
// energy that single-scattering lobes lack.
#include "bake/dielectric.h"
#include "bake/low_rank.h"
#include "bake/polynomial_fit.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 16, kEtas = 16, kCosines = 49, kTerms = 6;

std::vector<Axis> axes_of(Contrast contrast) {
    return {alpha_axis(kAlphas), eta_axis(contrast, kEtas), profile_axis(kCosines)};
}

void simulate_node(Contrast contrast, const Parameters& node, const Walks& walks,
                   std::uint64_t seed, std::span<float> values) {
    const std::vector<double> means = walks.light_reflected_again(
        profile_cosines(kCosines, contrast, node[1]), node[0], node[1], seed);
    for (std::size_t n = 0; n < kCosines; ++n) values[n] = static_cast<float>(means[n]);
}

void append_side(const std::string& name, Contrast contrast, Side side, const DenseValues& dense,
                 std::vector<TableArray>& arrays) {
    std::vector<Axis> axes = axes_of(contrast);
    axes.back() = channel_axis("coefficient", kTerms);
    arrays.push_back(make_array(
        name, axes, fit_polynomials(to_matrix(dense, kCosines), contrast, side, kTerms)));
}

std::vector<TableArray> compress(const std::vector<DenseValues>& dense) {
    std::vector<TableArray> arrays;
    append_side("thin_below", Contrast::thin, Side::below, dense[0], arrays);
    append_side("thin_above", Contrast::thin, Side::above, dense[0], arrays);
    append_side("dense_above", Contrast::dense, Side::above, dense[1], arrays);
    return arrays;
}

}  // namespace

TableBake bake_of_multiple() {
    std::vector<Quantity> quantities;
    for (const Contrast contrast : {Contrast::thin, Contrast::dense})
        quantities.push_back({contrast == Contrast::thin ? "multiple_thin" : "multiple_dense",
                              axes_of(contrast), 2,
                              [contrast](const Parameters& node, const Walks& walks,
                                         std::uint64_t seed, std::span<float> values) {
                                  simulate_node(contrast, node, walks, seed, values);
                              },
                              [contrast](const EnergyTables& tables, const Parameters& p) {
                                  const double cosine = profile_cosine(p[2], contrast, p[1]);
                                  return tables.fgd_multiple(cosine, p[0], p[1]);
                              }});
    return {"multiple", "light that a dielectric interface reflects after more than one facet",
            quantities, compress};
}

}  // namespace lacquer::bake
