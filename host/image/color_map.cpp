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

// Colours of differences at sizes 0, 1/3, 2/3, 1; lightness rises evenly and alike to both sides.
using Ramp = std::array<std::array<double, 3>, 4>;
constexpr Ramp kTooLittle{{{0, 0, 0}, {22, 72, 140}, {92, 160, 222}, {226, 242, 255}}};
constexpr Ramp kTooMuch{{{0, 0, 0}, {140, 48, 18}, {232, 132, 62}, {255, 238, 214}}};

std::uint8_t level(const Ramp& ramp, double size, std::size_t channel) {
    const double position = size * static_cast<double>(ramp.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(position), ramp.size() - 2);
    const double share = position - static_cast<double>(stop);
    return static_cast<std::uint8_t>(
        std::lround((1.0 - share) * ramp[stop][channel] + share * ramp[stop + 1][channel]));
}

}  // namespace

DisplayColor heat_color(double unit) {
    if (std::isnan(unit)) return kNotANumberColor;
    const double x = std::clamp(unit, 0.0, 1.0);
    return {level(kInferno[0], x), level(kInferno[1], x), level(kInferno[2], x), 255};
}

DisplayColor difference_color(double unit) {
    if (std::isnan(unit)) return kNotANumberColor;
    const double size = std::min(std::abs(unit), 1.0);
    const Ramp& ramp = unit < 0.0 ? kTooLittle : kTooMuch;
    return {level(ramp, size, 0), level(ramp, size, 1), level(ramp, size, 2), 255};
}

}  // namespace lacquer
