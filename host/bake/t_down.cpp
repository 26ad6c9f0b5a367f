// T01 over (cos_theta, alpha, eta, tau): its dense bake and its compression.
// Based on: de Dinechin and Belcour 2022, section 4. Differs: principal components for tau alone,
// and polynomials to both sides of the critical angle for cos_theta, which shading evaluates
// without reading a table and whose integrals are known.
#include "bake/dielectric.h"
#include "bake/low_rank.h"
#include "bake/polynomial_fit.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kCosines = 49;

// The critical angle moves with eta, which takes more nodes.
Axis t_down_alphas() {
    return alpha_axis(16);
}
Axis t_down_etas(Contrast contrast) {
    return eta_axis(contrast, contrast == Contrast::thin ? 24 : 16);
}

// Histogram nodes (rows) to transmittances of media (columns).
const Matrix& absorption_of_nodes() {
    static const Matrix matrix = [] {
        const Axis axis = tau_axis();
        Matrix result(static_cast<Eigen::Index>(CosineHistogram::kNodes),
                      static_cast<Eigen::Index>(axis.size));
        for (Eigen::Index node = 0; node < result.rows(); ++node)
            for (Eigen::Index t = 0; t < result.cols(); ++t) {
                CosineHistogram one;
                one.light[static_cast<std::size_t>(node)] = 1.0;
                result(node, t) = one.transmitted(axis_value(axis, static_cast<std::size_t>(t)));
            }
        return result;
    }();
    return matrix;
}

void simulate_node(Contrast contrast, const Parameters& node, const Walks& walks,
                   std::uint64_t seed, std::span<float> values) {
    const Matrix& absorption = absorption_of_nodes();
    const auto taus = static_cast<std::size_t>(absorption.cols());
    const std::vector<CosineHistogram> entered =
        walks.light_entering(profile_cosines(kCosines, contrast, node[1]), node[0], node[1], seed);
    for (std::size_t n = 0; n < kCosines; ++n) {
        const Eigen::Map<const Eigen::RowVectorXd> light(
            entered[n].light.data(), static_cast<Eigen::Index>(entered[n].light.size()));
        const Eigen::RowVectorXd transmitted = light * absorption;
        for (std::size_t t = 0; t < taus; ++t)
            values[n * taus + t] = static_cast<float>(transmitted[static_cast<Eigen::Index>(t)]);
    }
}

// What the errors at each node count for.
struct NodeWeights {
    Eigen::VectorXd by_node, by_cosine;  // by_node: over (alpha, eta)
    Eigen::VectorXd by_tau;
};

NodeWeights weights_of(Contrast contrast) {
    const Matrix nodes =
        node_weights(t_down_alphas().size) * node_weights(t_down_etas(contrast).size).transpose();
    NodeWeights weights{Eigen::Map<const Eigen::VectorXd>(nodes.data(), nodes.size()),
                        profile_weights(contrast, kCosines), node_weights(tau_axis().size)};
    // Clear media are the rule, and every other energy of an interface derives from them.
    constexpr double kClear = 8.0;
    weights.by_tau[0] *= kClear;
    return weights;
}

// Rows (alpha, eta, s), columns tau.
Matrix weighted_values(const DenseValues& dense, const NodeWeights& weights) {
    Matrix values = to_matrix(dense, static_cast<std::size_t>(weights.by_tau.size()));
    const Eigen::Index cosines = weights.by_cosine.size();
    for (Eigen::Index row = 0; row < values.rows(); ++row)
        values.row(row) *= weights.by_node[row / cosines] * weights.by_cosine[row % cosines];
    return values * weights.by_tau.asDiagonal();
}

// The factor of function k of tau: rows (alpha, eta), columns s.
Matrix factor_of(const Matrix& by_absorption, Eigen::Index k, const NodeWeights& weights) {
    const Eigen::Index nodes = weights.by_node.size(), cosines = weights.by_cosine.size();
    Matrix factor(nodes, cosines);
    for (Eigen::Index node = 0; node < nodes; ++node)
        factor.row(node) = by_absorption.col(k).segment(node * cosines, cosines).transpose() /
                           weights.by_node[node];
    return factor * weights.by_cosine.cwiseInverse().asDiagonal();
}

// Coefficients of all factors to one side, by coefficient_counts.
Matrix fit_side(const std::vector<Matrix>& factors, Contrast contrast, Side side) {
    const CoefficientCounts& counts = coefficient_counts(contrast);
    Matrix maps(factors.front().rows(), static_cast<Eigen::Index>(coefficient_channels(contrast)));
    Eigen::Index column = 0;
    for (std::size_t k = 0; k < kAbsorptions; ++k) {
        const Matrix fitted = fit_polynomials(factors[k], contrast, side, counts[k]);
        maps.middleCols(column, fitted.cols()) = fitted;
        column += fitted.cols();
    }
    return maps;
}

std::vector<TableArray> compress(Contrast contrast, const DenseValues& dense) {
    const NodeWeights weights = weights_of(contrast);
    const Matrix values = weighted_values(dense, weights);
    Matrix absorption = principal_rows(values, kAbsorptions);
    const Matrix by_absorption = values * absorption.transpose();
    absorption.array().rowwise() /= weights.by_tau.transpose().array();
    std::vector<Matrix> factors;
    for (std::size_t k = 0; k < kAbsorptions; ++k)
        factors.push_back(factor_of(by_absorption, static_cast<Eigen::Index>(k), weights));

    const std::vector<Axis> axes{t_down_alphas(), t_down_etas(contrast),
                                 channel_axis("coefficient", coefficient_channels(contrast))};
    std::vector<TableArray> arrays;
    if (contrast == Contrast::thin)
        arrays.push_back(make_array("below", axes, fit_side(factors, contrast, Side::below)));
    arrays.push_back(make_array("above", axes, fit_side(factors, contrast, Side::above)));
    arrays.push_back(make_array("absorption",
                                {tau_axis(), channel_axis("absorption", kAbsorptions)},
                                absorption.transpose()));
    return arrays;
}

}  // namespace

TableBake bake_of_t_down(Contrast contrast) {
    const bool thin = contrast == Contrast::thin;
    Quantity quantity{
        thin ? "t_down_thin" : "t_down_dense",
        {t_down_alphas(), t_down_etas(contrast), profile_axis(kCosines), tau_axis()},
        2,
        [contrast](const Parameters& node, const Walks& walks, std::uint64_t seed,
                   std::span<float> values) { simulate_node(contrast, node, walks, seed, values); },
        [contrast](const EnergyTables& tables, const Parameters& p) {
            const double cosine = profile_cosine(p[2], contrast, p[1]);
            return tables.t_down(cosine, p[0], p[1], p[3]);
        }};
    return {quantity.name,
            thin ? "T01 for eta <= 1: light entering and crossing the medium"
                 : "T01 for eta >= 1: light entering and crossing the medium",
            {quantity},
            [contrast](const std::vector<DenseValues>& dense) {
                return compress(contrast, dense.front());
            }};
}

}  // namespace lacquer::bake
