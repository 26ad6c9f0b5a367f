#include "support/normal.h"

#include <boost/math/special_functions/erf.hpp>
#include <cmath>
#include <numbers>

namespace lacquer::test {

double two_sided_z(double significance) {
    return std::numbers::sqrt2 * boost::math::erfc_inv(significance);
}

}  // namespace lacquer::test
