#include "reference/stack/published/operators_2018.h"

#include <algorithm>
#include <cmath>

#include "reference/stack/directions.h"

namespace lacquer::reference::published_2018 {

namespace {

constexpr double kPower = 1.1;
constexpr double kMostAlpha = 0.9995;  // whose variance is finite

// eta_12 cos_theta_i / cos_theta_t.
double ratio(double cosine, double refracted_cosine, double eta) {
    return cosine / (eta * std::max(refracted_cosine, kLeastCosine));
}

}  // namespace

double variance_of_alpha(double alpha) {
    const double power = std::pow(std::min(alpha, kMostAlpha), kPower);
    return power / (1.0 - power);
}

double alpha_of_variance(double variance) {
    return std::pow(variance / (1.0 + variance), 1.0 / kPower);
}

double refracted_sine(double sine, double eta) {
    return std::min(sine / eta, 1.0);
}

double refraction_scale(double cosine, double refracted_cosine, double eta) {
    return 0.5 * std::abs(1.0 - ratio(cosine, refracted_cosine, eta));
}

double refraction_scale_as_printed(double cosine, double refracted_cosine, double eta) {
    return 0.5 * (1.0 + ratio(cosine, refracted_cosine, eta));
}

double peak_scale(double eta) {
    return refraction_scale(1.0, 1.0, eta);
}

double refracted_variance_as_printed(double variance, double eta) {
    return variance * eta;
}

double refracted_variance(double variance, double eta) {
    return variance / eta;
}

}  // namespace lacquer::reference::published_2018
