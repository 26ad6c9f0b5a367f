#include "image/texture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

namespace lacquer {

namespace {

int wrapped(int i, int size) {
    return ((i % size) + size) % size;
}

}  // namespace

double sample_texture(const Image& image, char channel, const glm::dvec2& uv) {
    const auto index = std::string_view{"rgba"}.find(channel);
    assert(index != std::string_view::npos);
    const double x = uv.x * image.width - 0.5;
    const double y = std::clamp((1.0 - uv.y) * image.height - 0.5, 0.0, image.height - 1.0);
    const double x_floor = std::floor(x), y_floor = std::floor(y);
    const int x0 = wrapped(static_cast<int>(x_floor), image.width);
    const int x1 = wrapped(x0 + 1, image.width);
    const int y0 = static_cast<int>(y_floor);
    const int y1 = std::min(y0 + 1, image.height - 1);
    const auto value = [&](int column, int row) {
        return double{image.at(column, row)[static_cast<int>(index)]};
    };
    return std::lerp(std::lerp(value(x0, y0), value(x1, y0), x - x_floor),
                     std::lerp(value(x0, y1), value(x1, y1), x - x_floor), y - y_floor);
}

}  // namespace lacquer
