// Functions over the profile axis as polynomials to each side of the critical angle.
#pragma once

#include "bake/low_rank.h"
#include "tables/profile.h"

namespace lacquer::bake {

// To which side of the critical cosine; for a dense contrast all directions are above.
enum class Side { below, above };

// Square roots of what errors at the nodes of profile_axis(size) count for: the nodes crowd at the
// critical angle.
Eigen::VectorXd profile_weights(Contrast contrast, std::size_t size);

// Least squares by `count` Chebyshev polynomials (tables/polynomial.h). `rows` are functions over
// profile_axis; the result has their coefficients.
Matrix fit_polynomials(const Matrix& rows, Contrast contrast, Side side, std::size_t count);

}  // namespace lacquer::bake
