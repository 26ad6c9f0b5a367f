#include "image/color_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace lacquer {

namespace {

// Least-squares polynomials of degree 6 through the map's table, lowest power first.
// Coefficients: Matt Zucker 2019, "colormaps" (shadertoy.com/view/WlfXRN), public domain.
using Polynomial = std::array<double, 7>;
constexpr std::array<Polynomial, 3> kInferno{{
    {0.0002189403691192265, 0.1065134194856116, 11.60249308247187, -41.70399613139459,
     77.162935699427, -71.31942824499214, 25.13112622477341},
    {0.001651004631001012, 0.5639564367884091, -3.972853965665698, 17.43639888205313,
     -33.40235894210092, 32.62606426397723, -12.24266895238567},
    {-0.01948089843709184, 3.932712388889277, -15.9423941062914, 44.35414519872813,
     -81.80730925738993, 73.20951985803202, -23.07032500244401},
}};

std::uint8_t level(const Polynomial& polynomial, double x) {
    double value = 0.0;
    for (std::size_t power = polynomial.size(); power-- > 0;) value = value * x + polynomial[power];
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace

DisplayColor heat_color(double unit) {
    if (std::isnan(unit)) return kNotANumberColor;
    const double x = std::clamp(unit, 0.0, 1.0);
    return {level(kInferno[0], x), level(kInferno[1], x), level(kInferno[2], x), 255};
}

}  // namespace lacquer
