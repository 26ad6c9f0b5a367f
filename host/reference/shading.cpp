#include "reference/shading.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lacquer::reference {

bool is_above(const glm::dvec3& w) {
    return w.z > 0.0;
}

glm::dvec3 vector_of(const Rgb& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

double mean(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0;
}

// Malley's method: a uniform point of the unit disk, lifted to the hemisphere.
glm::dvec3 sample_cosine(const glm::dvec2& u) {
    const double radius = std::sqrt(u.x);
    const double phi = 2.0 * std::numbers::pi * u.y;
    return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(std::max(1.0 - u.x, 0.0))};
}

}  // namespace lacquer::reference
