#include "reference/stack/lobe_width.h"

#include <algorithm>
#include <cmath>

namespace lacquer::reference {

namespace {

constexpr double kMaxWidth = 0.999;  // whose variance is as good as infinite

}  // namespace

double width_of_alpha(double alpha) {
    return alpha * alpha;
}

double alpha_of_width(double width) {
    return std::sqrt(width);
}

double variance_of_width(double width) {
    const double most = std::min(width, kMaxWidth);
    return most / (1.0 - most);
}

double width_of_variance(double variance) {
    return variance / (1.0 + variance);
}

}  // namespace lacquer::reference
