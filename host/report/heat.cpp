#include "report/heat.h"

#include <algorithm>
#include <cmath>

#include "image/color_map.h"
#include "image/png.h"

namespace lacquer {

HeatScale::HeatScale(double limit) : limit_{limit} {
    palette_.push_back({0, 0, 0, 0});
    for (int step = 0; step < kSteps; ++step)
        palette_.push_back(heat_color(double(step) / (kSteps - 1)));
    palette_.push_back(kOverLimitColor);
    palette_.push_back(kNotANumberColor);
}

std::uint8_t HeatScale::index_of(float relative_error) const {
    if (!std::isfinite(relative_error)) return kNotFinite;
    if (relative_error > limit_) return kOver;
    const double decades = kDecades + std::log10(relative_error / limit_);
    const double step = std::floor(std::max(decades, 0.0) * kStepsPerDecade);
    return static_cast<std::uint8_t>(kFirstStep + std::min(step, double(kSteps - 1)));
}

std::string heat_png(const HeatScale& scale, std::span<const HeatTile> tiles) {
    const int size = tiles.front().grid->width;
    const int height = tiles.front().grid->height;
    const int width = size * static_cast<int>(tiles.size());
    std::vector<std::uint8_t> indices(static_cast<std::size_t>(width) * height,
                                      HeatScale::kNothing);
    for (std::size_t t = 0; t < tiles.size(); ++t) {
        for (std::size_t i = 0; i < tiles[t].relative_errors.size(); ++i) {
            const std::size_t pixel = tiles[t].grid->pixels[i];
            const std::size_t row = pixel / size, column = pixel % size + t * size;
            indices[row * width + column] = scale.index_of(tiles[t].relative_errors[i]);
        }
    }
    return encode_png(width, height, indices, scale.palette());
}

}  // namespace lacquer
