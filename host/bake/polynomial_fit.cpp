#include "bake/polynomial_fit.h"

#include <Eigen/QR>

namespace lacquer::bake {

namespace {

// The nodes of one side: `count` of the axis from `first` on, t running from 0 at the critical
// angle to 1.
struct Nodes {
    Eigen::Index first = 0, count = 0;
    bool descending = false;  // t falls with s

    double t(Eigen::Index node) const {
        const double share = static_cast<double>(node) / static_cast<double>(count - 1);
        return descending ? 1.0 - share : share;
    }
};

Nodes nodes_of(Contrast contrast, Side side, Eigen::Index size) {
    if (contrast == Contrast::dense) return {0, size, false};
    const Eigen::Index middle = size / 2;
    return side == Side::below ? Nodes{0, middle + 1, true} : Nodes{middle, size - middle, false};
}

Eigen::VectorXd side_weights(const Nodes& nodes) {
    Eigen::VectorXd weights = node_weights(static_cast<std::size_t>(nodes.count));
    if (nodes.descending) weights = weights.reverse().eval();
    return weights;
}

}  // namespace

Eigen::VectorXd profile_weights(Contrast contrast, std::size_t size) {
    const auto last = static_cast<Eigen::Index>(size);
    Eigen::VectorXd weights(last);
    if (contrast == Contrast::thin) {
        const Nodes below = nodes_of(contrast, Side::below, last);
        weights.segment(below.first, below.count) = side_weights(below);
    }
    const Nodes above = nodes_of(contrast, Side::above, last);
    weights.segment(above.first, above.count) = side_weights(above);
    return weights;
}

Matrix fit_polynomials(const Matrix& rows, Contrast contrast, Side side, std::size_t count) {
    const Nodes nodes = nodes_of(contrast, side, rows.cols());
    const Eigen::VectorXd weights = side_weights(nodes);
    const auto terms = static_cast<Eigen::Index>(count);
    Matrix basis(nodes.count, terms);
    for (Eigen::Index node = 0; node < nodes.count; ++node) {
        const double t = nodes.t(node);
        const double x = side == Side::below ? 1.0 - 2.0 * t : 2.0 * t - 1.0;
        basis(node, 0) = 1.0;
        if (terms > 1) basis(node, 1) = x;
        for (Eigen::Index n = 2; n < terms; ++n)
            basis(node, n) = 2.0 * x * basis(node, n - 1) - basis(node, n - 2);
    }
    const Matrix weighted_basis = weights.asDiagonal() * basis;
    const Matrix weighted_rows = rows.middleCols(nodes.first, nodes.count) * weights.asDiagonal();
    return weighted_basis.colPivHouseholderQr().solve(weighted_rows.transpose()).transpose();
}

}  // namespace lacquer::bake
