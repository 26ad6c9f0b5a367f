#include "study/display.h"

#include <fmt/format.h>

#include "image/color_map.h"
#include "image/display.h"
#include "image/png.h"

namespace lacquer::study {

namespace {

std::vector<DisplayColor> difference_pixels(const Image& image, double limit) {
    std::vector<DisplayColor> colors;
    colors.reserve(image.pixels.size());
    for (const glm::vec4& pixel : image.pixels)
        colors.push_back(pixel.w > 0.0f ? difference_color(double{pixel.x} / limit)
                                        : DisplayColor{0, 0, 0, 0});
    return colors;
}

}  // namespace

std::string png_of(const Picture& picture) {
    const Image& image = picture.numbers;
    return encode_png(
        image.width, image.height,
        picture.limit ? difference_pixels(image, *picture.limit) : display_pixels(image));
}

std::string difference_legend(double limit, const std::string& below, const std::string& above) {
    constexpr int kStops = 12;
    std::string stops;
    for (int stop = 0; stop <= kStops; ++stop) {
        const DisplayColor color = difference_color(2.0 * stop / kStops - 1.0);
        stops += fmt::format("{}rgb({} {} {})", stop == 0 ? "" : ",", color.r, color.g, color.b);
    }
    return fmt::format(
        R"html(<div class="scale"><span>&minus;{0:g}, {2}</span>
<i style="background:linear-gradient(90deg,{1})"></i><span>+{0:g}, {3}</span></div>)html",
        limit, stops, below, above);
}

}  // namespace lacquer::study
