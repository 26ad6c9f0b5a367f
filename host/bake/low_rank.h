// Principal components: the few functions that a table's slices are combinations of.
#pragma once

#include <Eigen/Core>

#include "bake/quantity.h"

namespace lacquer::bake {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Orthonormal rows: the `count` functions over columns that carry most of rows^T rows, the most
// first. Not centred: what is 0 in all rows is exactly 0 in all functions.
Matrix principal_rows(const Matrix& rows, std::size_t count);

// Square roots of t + floor over the nodes t of [0, 1] of an axis: a squared mapping puts most
// nodes near 0, where few points of a uniform distribution lie; so weighted, the error is minimised
// over the parameter and not over the nodes.
Eigen::VectorXd node_weights(std::size_t size);

Matrix to_matrix(const DenseValues& values, std::size_t columns);

// Appends two arrays: functions of the last axis of a dense bake, named `function`, and "maps" of
// their coefficients over its other axes.
void append_factors(const std::string& prefix, const std::string& function,
                    std::span<const Axis> axes, const DenseValues& dense, std::size_t count,
                    std::vector<TableArray>& arrays);

TableArray make_array(std::string name, std::vector<Axis> axes, const Matrix& values);

}  // namespace lacquer::bake
