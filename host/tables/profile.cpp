#include "tables/profile.h"

#include <algorithm>
#include <cmath>

namespace lacquer {

Contrast contrast_of(double eta) {
    return eta < 1.0 ? Contrast::thin : Contrast::dense;
}

double critical_cosine(double eta) {
    return std::sqrt(std::max(0.0, 1.0 - eta * eta));
}

double profile_coordinate(double cos_theta, double eta) {
    if (contrast_of(eta) == Contrast::dense) return std::sqrt(cos_theta);
    const double critical = critical_cosine(eta);
    if (cos_theta < critical) return 0.5 * (1.0 - std::sqrt(1.0 - cos_theta / critical));
    return 0.5 * (1.0 + std::sqrt((cos_theta - critical) / (1.0 - critical)));
}

double profile_cosine(double s, Contrast contrast, double eta) {
    if (contrast == Contrast::dense) return s * s;
    const double critical = critical_cosine(eta);
    const double t = 1.0 - 2.0 * s;
    return t > 0.0 ? critical * (1.0 - t * t) : critical + (1.0 - critical) * t * t;
}

}  // namespace lacquer
