#include "study/display.h"

#include <fmt/format.h>

#include "image/color_map.h"
#include "image/display.h"
#include "image/png.h"

namespace lacquer::study {

namespace {

std::vector<DisplayColor> difference_pixels(const Image& image, double limit,
                                            DisplayColor (*color)(double unit)) {
    std::vector<DisplayColor> colors;
    colors.reserve(image.pixels.size());
    for (const glm::vec4& pixel : image.pixels)
        colors.push_back(pixel.w > 0.0f ? color(double{pixel.x} / limit)
                                        : DisplayColor{0, 0, 0, 0});
    return colors;
}

// Of so many equal steps of a map: for a CSS gradient.
std::string color_stops(double from, DisplayColor (*color)(double unit)) {
    constexpr int kStops = 12;
    std::string stops;
    for (int stop = 0; stop <= kStops; ++stop) {
        const DisplayColor at = color(from + (1.0 - from) * stop / kStops);
        stops += fmt::format("{}rgb({} {} {})", stop == 0 ? "" : ",", at.r, at.g, at.b);
    }
    return stops;
}

std::string legend(const std::string& low, const std::string& stops, const std::string& high) {
    return fmt::format(
        R"html(<div class="scale"><span>{}</span>
<i style="background:linear-gradient(90deg,{})"></i><span>{}</span></div>)html",
        low, stops, high);
}

}  // namespace

std::string png_of(const Picture& picture) {
    const Image& image = picture.numbers;
    return encode_png(image.width, image.height,
                      picture.limit
                          ? difference_pixels(image, *picture.limit,
                                              picture.to_the_eye ? heat_color : difference_color)
                          : display_pixels(image));
}

std::string difference_legend(double limit, const std::string& below, const std::string& above) {
    return legend(fmt::format("&minus;{:g}, {}", limit, below), color_stops(-1.0, difference_color),
                  fmt::format("+{:g}, {}", limit, above));
}

std::string flip_legend(double limit) {
    return legend("FLIP 0, looks the same", color_stops(0.0, heat_color),
                  fmt::format("{:g}", limit));
}

}  // namespace lacquer::study
