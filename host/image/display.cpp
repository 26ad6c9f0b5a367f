#include "image/display.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace lacquer {

namespace {

std::uint8_t to_level(double unit) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(unit, 0.0, 1.0)));
}

bool has_nan(const glm::vec4& color) {
    return std::isnan(color.x) || std::isnan(color.y) || std::isnan(color.z) || std::isnan(color.w);
}

}  // namespace

double tone_curve(double radiance) {
    return radiance > 0.0 ? -std::expm1(-radiance) : 0.0;
}

double srgb_encode(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
}

double srgb_decode(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

DisplayColor display_color(const glm::vec4& premultiplied) {
    if (has_nan(premultiplied)) return kNotANumberColor;
    const double alpha = std::clamp(static_cast<double>(premultiplied.w), 0.0, 1.0);
    if (alpha == 0.0) return {0, 0, 0, 0};
    const auto level = [alpha](float channel) {
        return to_level(srgb_encode(tone_curve(channel / alpha)));
    };
    return {level(premultiplied.x), level(premultiplied.y), level(premultiplied.z),
            to_level(alpha)};
}

std::vector<DisplayColor> display_pixels(const Image& image) {
    std::vector<DisplayColor> colors;
    colors.reserve(image.pixels.size());
    std::transform(image.pixels.begin(), image.pixels.end(), std::back_inserter(colors),
                   display_color);
    return colors;
}

}  // namespace lacquer
