// FGD of conductors over (cos_theta, alpha, eta, kappa), all orders: functions of the facets times
// functions of the material, of which few are needed because for fixed facets FGD is nearly linear
// in the Fresnel curve. Along cos_theta they are polynomials, so that shading contracts the table
// once per surface.
#include <complex>

#include "bake/low_rank.h"
#include "bake/mirror.h"
#include "bake/polynomial_fit.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 16, kCosines = 24, kEtas = 24, kKappas = 24;

Axis cosine_axis() {
    return {"cos_theta", Mapping::squared, kCosines, 0.0, 1.0, "1"};
}
Axis material_eta_axis() {
    return {"eta", Mapping::squared, kEtas, 0.0, 5.0, "1"};
}
Axis kappa_axis() {
    return {"kappa", Mapping::squared, kKappas, 0.0, 10.0, "1"};
}

const Conductors& conductors() {
    static const Conductors all = [] {
        std::vector<Conductors::Index> indices;
        for (std::size_t n = 0; n < kEtas * kKappas; ++n)
            indices.push_back({axis_value(material_eta_axis(), n / kKappas),
                               axis_value(kappa_axis(), n % kKappas)});
        return Conductors{std::move(indices)};
    }();
    return all;
}

void simulate_node(const Parameters& node, const Walks& walks, std::uint64_t seed,
                   std::span<float> values) {
    const std::vector<double> reflected =
        walks.reflected_by_conductors(node[1], node[0], conductors(), seed);
    for (std::size_t n = 0; n < reflected.size(); ++n) values[n] = static_cast<float>(reflected[n]);
}

Eigen::VectorXd pair_weights(std::size_t slow, std::size_t fast) {
    const Matrix outer = node_weights(slow) * node_weights(fast).transpose();
    return Eigen::Map<const Eigen::VectorXd>(outer.data(), outer.size());
}

// Square roots of what errors count for. Nothing absorbs so little as conductors of small kappa:
// these, some of which reflect totally, would else use up the functions.
Eigen::VectorXd material_weights() {
    constexpr double kLowKappa = 0.5, kLowWeight = 0.3;
    Eigen::VectorXd weights = pair_weights(kEtas, kKappas);
    for (std::size_t n = 0; n < kEtas * kKappas; ++n)
        if (axis_value(kappa_axis(), n % kKappas) < kLowKappa)
            weights[static_cast<Eigen::Index>(n)] *= kLowWeight;
    return weights;
}

// Chebyshev coefficients of the terms at each alpha, term after term. `facets` has a column per
// term and a row per (alpha, cos_theta).
Matrix coefficients_of(const Matrix& facets) {
    Matrix coefficients(static_cast<Eigen::Index>(kAlphas),
                        static_cast<Eigen::Index>(kConductorTerms * kCoefficients));
    for (std::size_t term = 0; term < kConductorTerms; ++term) {
        const Eigen::VectorXd column = facets.col(static_cast<Eigen::Index>(term));
        const Matrix rows = Eigen::Map<const Matrix>(
            column.data(), static_cast<Eigen::Index>(kAlphas), static_cast<Eigen::Index>(kCosines));
        coefficients.middleCols(static_cast<Eigen::Index>(term * kCoefficients), kCoefficients) =
            fit_polynomials(rows, Contrast::dense, Side::above, kCoefficients);
    }
    return coefficients;
}

std::vector<TableArray> compress(const DenseValues& dense) {
    const Eigen::VectorXd by_facets = pair_weights(kAlphas, kCosines);
    const Eigen::VectorXd by_material = material_weights();
    const Matrix values = to_matrix(dense, kEtas * kKappas);
    const Matrix weighted = by_facets.asDiagonal() * values * by_material.asDiagonal();
    Matrix materials = principal_rows(weighted, kConductorTerms);
    Matrix facets = weighted * materials.transpose();
    facets.array().colwise() /= by_facets.array();
    materials.array().rowwise() /= by_material.transpose().array();
    const Axis coefficients = channel_axis("coefficient", kConductorTerms * kCoefficients);
    const Axis terms = channel_axis("term", kConductorTerms);
    return {
        make_array("facets", {alpha_axis(kAlphas), coefficients}, coefficients_of(facets)),
        make_array("materials", {material_eta_axis(), kappa_axis(), terms}, materials.transpose())};
}

}  // namespace

TableBake bake_of_conductor() {
    return {"conductor",
            "FGD of conductors",
            {{"conductor",
              {alpha_axis(kAlphas), cosine_axis(), material_eta_axis(), kappa_axis()},
              2,
              simulate_node,
              [](const EnergyTables& tables, const Parameters& p) {
                  return tables.fgd_conductor(p[1], p[0], p[2], p[3]);
              }}},
            [](const std::vector<DenseValues>& dense) { return compress(dense.front()); }};
}

}  // namespace lacquer::bake
