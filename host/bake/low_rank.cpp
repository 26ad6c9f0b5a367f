#include "bake/low_rank.h"

#include <Eigen/Eigenvalues>

namespace lacquer::bake {

Matrix principal_rows(const Matrix& rows, std::size_t count) {
    const Matrix gram = rows.transpose() * rows;
    const Eigen::SelfAdjointEigenSolver<Matrix> solver{gram};
    const auto wanted = static_cast<Eigen::Index>(count);
    Matrix result = solver.eigenvectors().rightCols(wanted).rowwise().reverse().transpose();
    // The sign of an eigenvector is arbitrary; positive sums make files easier to compare.
    for (Eigen::Index row = 0; row < wanted; ++row)
        if (result.row(row).sum() < 0.0) result.row(row) *= -1.0;
    return result;
}

Eigen::VectorXd node_weights(std::size_t size) {
    constexpr double kFloor = 0.1;  // so that the crowded end is fitted too
    const auto last = static_cast<double>(size - 1);
    Eigen::VectorXd weights(static_cast<Eigen::Index>(size));
    for (std::size_t node = 0; node < size; ++node)
        weights[static_cast<Eigen::Index>(node)] =
            std::sqrt(static_cast<double>(node) / last + kFloor);
    return weights;
}

Matrix to_matrix(const DenseValues& values, std::size_t columns) {
    using Floats = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    const auto width = static_cast<Eigen::Index>(columns);
    return Eigen::Map<const Floats>(values.data(), static_cast<Eigen::Index>(values.size()) / width,
                                    width)
        .cast<double>();
}

void append_factors(const std::string& prefix, const std::string& function,
                    std::span<const Axis> axes, const DenseValues& dense, std::size_t count,
                    std::vector<TableArray>& arrays) {
    const Matrix values = to_matrix(dense, axes.back().size);
    const Matrix functions = principal_rows(values, count);
    const Axis channels = channel_axis(function, count);
    std::vector<Axis> map_axes(axes.begin(), axes.end());
    map_axes.back() = channels;
    arrays.push_back(make_array(prefix + "maps", map_axes, values * functions.transpose()));
    arrays.push_back(make_array(prefix + function, {axes.back(), channels}, functions.transpose()));
}

TableArray make_array(std::string name, std::vector<Axis> axes, const Matrix& values) {
    return {std::move(name), std::move(axes),
            std::vector<double>(values.data(), values.data() + values.size()), Encoding::float16};
}

}  // namespace lacquer::bake
