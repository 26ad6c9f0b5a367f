// T01 over (cos_theta, alpha, eta, tau): its dense bake and its compression.
// Based on: de Dinechin and Belcour 2022, section 4. Differs: the cosine axis follows the critical
// angle, and of the products of basis functions only those that carry energy are kept.
#include "bake/dielectric.h"
#include "bake/low_rank.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kCosines = 49;

// The critical angle moves with eta, which takes more nodes.
Axis t_down_alphas() {
    return alpha_axis(16);
}
Axis t_down_etas(Contrast contrast) {
    return eta_axis(contrast, contrast == Contrast::thin ? 28 : 16);
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

void simulate_node(Contrast contrast, const Parameters& node, const SobolPoints& points,
                   std::uint64_t seed, std::span<float> values) {
    const Matrix& absorption = absorption_of_nodes();
    const auto taus = static_cast<std::size_t>(absorption.cols());
    const Axis cosines = profile_axis(kCosines);
    for (std::size_t n = 0; n < kCosines; ++n) {
        const double cosine = profile_cosine(axis_value(cosines, n), contrast, node[1]);
        const CosineHistogram entered =
            light_entering(cosine, node[0], node[1], points, mix_bits(seed + n));
        const Eigen::Map<const Eigen::RowVectorXd> light(
            entered.light.data(), static_cast<Eigen::Index>(entered.light.size()));
        const Eigen::RowVectorXd transmitted = light * absorption;
        for (std::size_t t = 0; t < taus; ++t)
            values[n * taus + t] = static_cast<float>(transmitted[static_cast<Eigen::Index>(t)]);
    }
}

// Weights of the cosine axis's nodes, which crowd where the mapping is flat.
Eigen::VectorXd cosine_weights(Contrast contrast) {
    if (contrast == Contrast::dense) return node_weights(kCosines);
    Eigen::VectorXd weights(static_cast<Eigen::Index>(kCosines));
    const Eigen::VectorXd side = node_weights(kCosines / 2 + 1);
    for (Eigen::Index n = 0; n < weights.size(); ++n)
        weights[n] = side[std::abs(n - static_cast<Eigen::Index>(kCosines / 2))];
    return weights;
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
                        cosine_weights(contrast), node_weights(tau_axis().size)};
    // Clear media are the rule, and every other energy of an interface derives from them.
    constexpr double kClear = 2.0;
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

// From rows (alpha, eta, s) and columns k to rows (alpha, eta, k) and columns s.
Matrix along_cosine(const Matrix& by_absorption, Eigen::Index cosines) {
    const Eigen::Index nodes = by_absorption.rows() / cosines, count = by_absorption.cols();
    Matrix result(nodes * count, cosines);
    for (Eigen::Index node = 0; node < nodes; ++node)
        result.middleRows(node * count, count) =
            by_absorption.middleRows(node * cosines, cosines).transpose();
    return result;
}

// The kept coefficients of every node, from rows (alpha, eta, k) and columns m.
Matrix kept_products(const Matrix& coefficients, const Eigen::VectorXd& by_node) {
    Matrix maps(by_node.size(), static_cast<Eigen::Index>(kProducts));
    for (Eigen::Index node = 0; node < maps.rows(); ++node) {
        Eigen::Index column = 0;
        for (std::size_t k = 0; k < kAbsorptions; ++k)
            for (std::size_t m = 0; m < kProfilesOf[k]; ++m)
                maps(node, column++) = coefficients(node * static_cast<Eigen::Index>(kAbsorptions) +
                                                        static_cast<Eigen::Index>(k),
                                                    static_cast<Eigen::Index>(m)) /
                                       by_node[node];
    }
    return maps;
}

std::vector<TableArray> compress(Contrast contrast, const DenseValues& dense) {
    const NodeWeights weights = weights_of(contrast);
    const Matrix values = weighted_values(dense, weights);
    Matrix absorption = principal_rows(values, kAbsorptions);
    const Matrix rows = along_cosine(values * absorption.transpose(), weights.by_cosine.size());
    Matrix profile = principal_rows(rows, kProfiles);
    const Matrix maps = kept_products(rows * profile.transpose(), weights.by_node);
    absorption.array().rowwise() /= weights.by_tau.transpose().array();
    profile.array().rowwise() /= weights.by_cosine.transpose().array();
    return {make_array("maps",
                       {t_down_alphas(), t_down_etas(contrast), channel_axis("product", kProducts)},
                       maps),
            make_array("profile", {profile_axis(kCosines), channel_axis("profile", kProfiles)},
                       profile.transpose()),
            make_array("absorption", {tau_axis(), channel_axis("absorption", kAbsorptions)},
                       absorption.transpose())};
}

}  // namespace

TableBake bake_of_t_down(Contrast contrast) {
    const bool thin = contrast == Contrast::thin;
    Quantity quantity{thin ? "t_down_thin" : "t_down_dense",
                      {t_down_alphas(), t_down_etas(contrast), profile_axis(kCosines), tau_axis()},
                      2,
                      [contrast](const Parameters& node, const SobolPoints& points,
                                 std::uint64_t seed, std::span<float> values) {
                          simulate_node(contrast, node, points, seed, values);
                      },
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
