#include "support/quadrature.h"

#include <cmath>
#include <numbers>

namespace lacquer::test {

double integrate_hemisphere(const std::function<double(const glm::dvec3&)>& f, int steps) {
    constexpr double kPi = std::numbers::pi;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double t = (i + 0.5) / steps;
        const double theta = t * t * kPi / 2;
        const double stretch = t * kPi;  // d theta / d t
        for (int j = 0; j < steps; ++j) {
            const double phi = 2 * kPi * (j + 0.5) / steps;
            const glm::dvec3 w{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                               std::cos(theta)};
            sum += f(w) * std::sin(theta) * stretch;
        }
    }
    return sum * (1.0 / steps) * (2 * kPi / steps);
}

glm::dvec3 mean_over_cube(const std::function<glm::dvec3(const glm::dvec3& u)>& f, int points) {
    constexpr double kSecond = 0.7548776662466927, kThird = 0.5698402909980532;
    glm::dvec3 sum{0.0};
    for (int n = 0; n < points; ++n)
        sum += f({(n + 0.5) / points, std::fmod(n * kSecond, 1.0), std::fmod(n * kThird, 1.0)});
    return sum / double(points);
}

}  // namespace lacquer::test
