// What single-scattering mirrors keep, over (cos_theta, alpha), and its average: the energies that
// multiple-scattering compensation fills up. And which alpha's lobe has a given variance.
#include <cmath>
#include <numbers>

#include "bake/low_rank.h"
#include "bake/mirror.h"

namespace lacquer::bake {

namespace {

constexpr std::size_t kAlphas = 24, kCosines = 32, kVariances = 65;

Axis cosine_axis() {
    return {"cos_theta", Mapping::squared, kCosines, 0.0, 1.0, "1"};
}

void simulate_node(const Parameters& node, const Walks& walks, std::uint64_t seed,
                   std::span<float> values) {
    values[0] = static_cast<float>(walks.reflected_once(node[1], node[0], seed));
}

// 2 * integral of a function cos dcos, piecewise linear in sqrt(cos) between the nodes: exact by
// Gauss-Legendre, whose three points integrate polynomials of degree 5.
double hemispherical_average(const Eigen::RowVectorXd& values) {
    constexpr std::array<double, 3> kPoints{-0.7745966692414834, 0.0, 0.7745966692414834};
    constexpr std::array<double, 3> kWeights{5.0 / 9.0, 8.0 / 9.0, 5.0 / 9.0};
    const auto segments = values.size() - 1;
    const double step = 1.0 / static_cast<double>(segments);
    double sum = 0.0;
    for (Eigen::Index n = 0; n < segments; ++n)
        for (std::size_t point = 0; point < kPoints.size(); ++point) {
            const double share = 0.5 * (1.0 + kPoints[point]);
            const double t = (static_cast<double>(n) + share) * step;
            const double value = values[n] + share * (values[n + 1] - values[n]);
            sum += 0.5 * kWeights[point] * step * value * 4.0 * t * t * t;
        }
    return sum;
}

// Per axis of the projected disk, of the lobe D G1 / 4 that GGX mirrors make of light along the
// normal. Its directions are even in w = 1 - 1 / (1 + tan^2 theta_m / alpha^2).
double normal_lobe_variance(double alpha) {
    constexpr int kSteps = 4096;
    const double alpha2 = alpha * alpha;
    const double end = 1.0 / (1.0 + alpha2);  // facets of 45 degrees send light along the plane
    double energy = 0.0, spread = 0.0;
    for (int n = 0; n < kSteps; ++n) {
        const double w = end * (n + 0.5) / kSteps;
        const double tan2_m = alpha2 * w / (1.0 - w);
        const double cosine = (1.0 - tan2_m) / (1.0 + tan2_m);
        const double sine2 = 1.0 - cosine * cosine;
        const double masking = 2.0 / (1.0 + std::sqrt(1.0 + alpha2 * sine2 / (cosine * cosine)));
        energy += masking;
        spread += 0.5 * masking * sine2;
    }
    return spread / energy;
}

// normal_lobe_variance(1), where the integrals are elementary.
constexpr double kMaxLobeVariance = 1.0 / (12.0 * (1.0 - std::numbers::ln2));

// The alpha whose lobe has a given variance, which grows with alpha: by bisection.
TableArray equivalent_alphas() {
    const Axis variances{"variance", Mapping::squared, kVariances, 0.0, kMaxLobeVariance, "1"};
    Matrix alphas(static_cast<Eigen::Index>(kVariances), 1);
    for (std::size_t n = 0; n < kVariances; ++n) {
        constexpr int kHalvings = 40;
        double low = 0.0, high = 1.0;
        for (int halving = 0; halving < kHalvings; ++halving) {
            const double middle = 0.5 * (low + high);
            (normal_lobe_variance(middle) < axis_value(variances, n) ? low : high) = middle;
        }
        alphas(static_cast<Eigen::Index>(n), 0) = 0.5 * (low + high);
    }
    return make_array("equivalent_alpha", {variances, channel_axis("alpha", 1)}, alphas);
}

std::vector<TableArray> compress(const DenseValues& dense) {
    const Matrix single = to_matrix(dense, kCosines);
    Matrix average(single.rows(), 1);
    for (Eigen::Index row = 0; row < single.rows(); ++row)
        average(row, 0) = hemispherical_average(single.row(row));
    const Axis one = channel_axis("energy", 1);
    return {make_array("single", {alpha_axis(kAlphas), cosine_axis(), one}, single),
            make_array("average", {alpha_axis(kAlphas), one}, average), equivalent_alphas()};
}

}  // namespace

TableBake bake_of_mirror() {
    return {"mirror",
            "directional and average albedo of single-scattering mirror facets",
            {{"mirror",
              {alpha_axis(kAlphas), cosine_axis()},
              2,
              simulate_node,
              [](const EnergyTables& tables, const Parameters& p) {
                  return tables.mirror_single(p[1], p[0]);
              }}},
            [](const std::vector<DenseValues>& dense) { return compress(dense.front()); }};
}

}  // namespace lacquer::bake
