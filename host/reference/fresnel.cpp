#include "reference/fresnel.h"

#include <algorithm>

namespace lacquer::reference {

namespace {

using Complex = std::complex<double>;

// |numerator / denominator|^2, and its limit 1 at grazing incidence on a boundary without contrast
// and at normal incidence on an index of 0, where both are 0.
double power_ratio(Complex numerator, Complex denominator) {
    const double below = std::norm(denominator);
    return below > 0.0 ? std::norm(numerator) / below : 1.0;
}

}  // namespace

double fresnel(double cos_theta_i, std::complex<double> eta) {
    const double c = std::clamp(cos_theta_i, 0.0, 1.0);
    // eta cos_theta_t by Snell's law; the principal root is the wave that decays.
    const Complex refracted = std::sqrt(eta * eta - (1.0 - c * c));
    const double perpendicular = power_ratio(c - refracted, c + refracted);
    const double parallel = power_ratio(eta * eta * c - refracted, eta * eta * c + refracted);
    return 0.5 * (perpendicular + parallel);
}

}  // namespace lacquer::reference
