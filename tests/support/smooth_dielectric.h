// A smooth dielectric interface in closed form.
#pragma once

#include <cmath>

namespace lacquer::test {

// Fresnel reflectance by its amplitudes; cos_i in (0, 1], eta = ior below / ior above.
inline double smooth_reflectance(double cos_i, double eta) {
    const double sin2_t = (1.0 - cos_i * cos_i) / (eta * eta);
    if (sin2_t >= 1.0) return 1.0;
    const double cos_t = std::sqrt(1.0 - sin2_t);
    const double s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const double p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return 0.5 * (s * s + p * p);
}

// Share of diffuse light that is reflected: 2 * integral of F cos dcos, by the midpoint rule.
inline double smooth_diffuse_reflectance(double eta) {
    constexpr int kSteps = 100'000;  // to 1e-7
    double sum = 0.0;
    for (int step = 0; step < kSteps; ++step) {
        const double cosine = (step + 0.5) / kSteps;
        sum += 2.0 * cosine * smooth_reflectance(cosine, eta);
    }
    return sum / kSteps;
}

}  // namespace lacquer::test
