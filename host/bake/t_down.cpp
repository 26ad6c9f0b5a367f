// T01 over (cos_theta, alpha, eta, tau): its dense bake and its compression.
// Based on: de Dinechin and Belcour 2022, section 4. Differs: the cosine axis follows the critical
// angle, and one joint rank over (alpha, eta) replaces the order cos-alpha, eta, tau.
#include "bake/dielectric.h"
#include "bake/low_rank.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 16, kEtas = 24, kCosines = 49;

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

std::vector<TableArray> compress(Contrast contrast, const DenseValues& dense) {
    const Axis alphas = alpha_axis(kAlphas), etas = eta_axis(contrast, kEtas), taus = tau_axis();
    const Eigen::VectorXd by_alpha = node_weights(kAlphas), by_eta = node_weights(kEtas);
    const Eigen::VectorXd by_cosine = cosine_weights(contrast);
    const auto nodes = static_cast<Eigen::Index>(kAlphas * kEtas);
    const auto cosines = static_cast<Eigen::Index>(kCosines);
    const auto etas_count = static_cast<Eigen::Index>(kEtas);

    // Rows (alpha, eta, s), columns tau.
    Matrix values = to_matrix(dense, taus.size);
    for (Eigen::Index row = 0; row < values.rows(); ++row) {
        const Eigen::Index node = row / cosines;
        values.row(row) *=
            by_alpha[node / etas_count] * by_eta[node % etas_count] * by_cosine[row % cosines];
    }
    const Matrix absorption = principal_rows(values, kAbsorptions);
    const Matrix by_absorption = values * absorption.transpose();

    // The same numbers with rows (alpha, eta, k), columns s.
    const auto absorptions = static_cast<Eigen::Index>(kAbsorptions);
    Matrix along_cosine(nodes * absorptions, cosines);
    for (Eigen::Index node = 0; node < nodes; ++node)
        along_cosine.middleRows(node * absorptions, absorptions) =
            by_absorption.middleRows(node * cosines, cosines).transpose();
    Matrix profile = principal_rows(along_cosine, kProfiles);
    const Matrix coefficients = along_cosine * profile.transpose();

    // Rows (alpha, eta), columns (k, m).
    const Matrix products = Eigen::Map<const Matrix>(
        coefficients.data(), nodes, static_cast<Eigen::Index>(kAbsorptions * kProfiles));
    const Matrix core = principal_rows(products, kRanks);
    Matrix maps = products * core.transpose();
    for (Eigen::Index node = 0; node < nodes; ++node)
        maps.row(node) /= by_alpha[node / etas_count] * by_eta[node % etas_count];
    profile.array().rowwise() /= by_cosine.transpose().array();

    return {make_array("maps", {alphas, etas, channel_axis("rank", kRanks)}, maps),
            make_array(
                "core",
                {channel_axis("rank", kRanks), channel_axis("product", kAbsorptions * kProfiles)},
                core),
            make_array("profile", {profile_axis(kCosines), channel_axis("profile", kProfiles)},
                       profile.transpose()),
            make_array("absorption", {taus, channel_axis("absorption", kAbsorptions)},
                       absorption.transpose())};
}

}  // namespace

TableBake bake_of_t_down(Contrast contrast) {
    const bool thin = contrast == Contrast::thin;
    Quantity quantity{
        thin ? "t_down_thin" : "t_down_dense",
        {alpha_axis(kAlphas), eta_axis(contrast, kEtas), profile_axis(kCosines), tau_axis()},
        2,
        [contrast](const Parameters& node, const SobolPoints& points, std::uint64_t seed,
                   std::span<float> values) {
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
