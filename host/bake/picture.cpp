#include "bake/picture.h"

#include <algorithm>

namespace lacquer::bake {

namespace {

constexpr int kGap = 1;  // pixels between tiles

// An array as tiles of the same size, one per channel, side by side.
struct Tiles {
    const TableArray& array;

    std::size_t rows() const { return array.axes.size() > 2 ? array.axes.front().size : 1; }
    std::size_t columns() const { return grid_size(array.axes) / array.channels() / rows(); }
    int width() const {
        return static_cast<int>(array.channels()) * (static_cast<int>(columns()) + kGap) - kGap;
    }
};

void draw(const Tiles& tiles, int top, Image& image) {
    const std::size_t channels = tiles.array.channels();
    for (std::size_t row = 0; row < tiles.rows(); ++row)
        for (std::size_t column = 0; column < tiles.columns(); ++column)
            for (std::size_t channel = 0; channel < channels; ++channel) {
                const std::size_t index = (row * tiles.columns() + column) * channels + channel;
                const auto value = static_cast<float>(tiles.array.values[index]);
                const std::size_t x = channel * (tiles.columns() + kGap) + column;
                image.at(static_cast<int>(x), top + static_cast<int>(row)) = {value, value, value,
                                                                              1.0f};
            }
}

}  // namespace

Image picture_of(const Table& table) {
    int width = 1, height = 0;
    for (const TableArray& array : table.arrays) {
        const Tiles tiles{array};
        width = std::max(width, tiles.width());
        height += static_cast<int>(tiles.rows()) + kGap;
    }
    Image image{width, height};
    int top = 0;
    for (const TableArray& array : table.arrays) {
        const Tiles tiles{array};
        draw(tiles, top, image);
        top += static_cast<int>(tiles.rows()) + kGap;
    }
    return image;
}

}  // namespace lacquer::bake
