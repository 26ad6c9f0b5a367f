// A picture in memory: linear radiance or any other numbers, not yet made for a display.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

namespace lacquer {

// Rows from the top, pixels from the left; (r, g, b, alpha), linear Rec. 709. Colours are
// premultiplied: where alpha is 0, nothing was computed and the colour is 0 too.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<glm::vec4> pixels;

    Image() = default;
    Image(int columns, int rows)
        : width{columns},
          height{rows},
          pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}

    glm::vec4& at(int x, int y) { return pixels[index(x, y)]; }
    const glm::vec4& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(x);
    }
};

}  // namespace lacquer
