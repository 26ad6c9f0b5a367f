#include "reference/ggx.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace lacquer::reference::ggx {

using std::numbers::pi;

double slope_density(double slope) {
    const double s = 1.0 + slope * slope;
    return 1.0 / (pi * s * s);
}

double lambda(double a) {
    return 0.5 * (-1.0 + std::sqrt(1.0 + 1.0 / (a * a)));
}

glm::dvec3 sample_visible_normal(const glm::dvec3& w, const glm::dvec2& u) {
    const double phi = 2.0 * pi * u.x;
    const double z = (1.0 - u.y) * (1.0 + w.z) - w.z;
    const double sin_theta = std::sqrt(std::max(1.0 - z * z, 0.0));
    const glm::dvec3 point{sin_theta * std::cos(phi), sin_theta * std::sin(phi), z};
    return glm::normalize(point + w);
}

}  // namespace lacquer::reference::ggx
