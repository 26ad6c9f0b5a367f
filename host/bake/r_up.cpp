// R10_bar over (alpha, eta, tau): how much of the light reflected inside the two crossings of the
// medium leave, relative to a clear medium, whose value follows from T01.
#include "bake/dielectric.h"
#include "bake/low_rank.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 16, kEtas = 16, kTerms = 6;

std::vector<Axis> axes_of(Contrast contrast) {
    return {alpha_axis(kAlphas), eta_axis(contrast, kEtas), tau_axis()};
}

void simulate_node(const Parameters& node, const Walks& walks, std::uint64_t seed,
                   std::span<float> values) {
    const CosineHistogram reflected = walks.light_leaving(node[0], node[1], seed).reflected;
    const Axis taus = tau_axis();
    const double clear = reflected.transmitted(1.0);
    for (std::size_t t = 0; t < taus.size; ++t) {
        // The histogram's cosine is that of a path of two crossings.
        const double dimmed = reflected.transmitted(axis_value(taus, t), 2.0);
        values[t] = static_cast<float>(clear > 0.0 ? dimmed / clear - 1.0 : 0.0);
    }
}

}  // namespace

TableBake bake_of_r_up() {
    std::vector<Quantity> quantities;
    for (const Contrast contrast : {Contrast::thin, Contrast::dense})
        quantities.push_back({contrast == Contrast::thin ? "r_up_thin" : "r_up_dense",
                              axes_of(contrast), 2, simulate_node,
                              [](const EnergyTables& tables, const Parameters& p) {
                                  return tables.r_up_dimming(p[0], p[1], p[2]) - 1.0;
                              }});
    return {"r_up", "R10_bar over its value for a clear medium, less 1", quantities,
            [](const std::vector<DenseValues>& dense) {
                std::vector<TableArray> arrays;
                append_factors("thin_", "absorption", axes_of(Contrast::thin), dense[0], kTerms,
                               arrays);
                append_factors("dense_", "absorption", axes_of(Contrast::dense), dense[1], kTerms,
                               arrays);
                return arrays;
            }};
}

}  // namespace lacquer::bake
