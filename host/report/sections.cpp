#include "report/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "image/display.h"
#include "image/png.h"
#include "markup/markup.h"

namespace lacquer {

namespace {

// Hues of the margin scale, in degrees.
constexpr double kGoodHue = 155.0, kNearHue = 45.0, kOverHue = 4.0;
constexpr double kGoodMargin = 1e-2;  // of the limit and below: as good as it gets

// Averages blocks of `factor` x `factor` pixels.
Image shrunk(const Image& image, int factor) {
    Image result{image.width / factor, image.height / factor};
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (int i = 0; i < factor * factor; ++i)
                result.at(x, y) += image.at(x * factor + i % factor, y * factor + i / factor) /
                                   float(factor * factor);
    return result;
}

const QueryGrid* sphere_of(const CompareResult& result, std::size_t& index) {
    for (index = 0; index < result.grids.size(); ++index)
        if (result.grids[index].kernel == Kernel::sphere) return &result.grids[index];
    return nullptr;
}

}  // namespace

std::string error_html(double error) {
    if (!std::isfinite(error)) return "not finite";
    if (error == 0.0) return "0";
    const std::string text = fmt::format("{:.1e}", error);  // "6.4e-05"
    const std::size_t exponent = text.find('e');
    return fmt::format("{}<span class=\"power\">e{}</span>", text.substr(0, exponent),
                       std::stoi(text.substr(exponent + 1)));
}

std::string status_pill(Status status) {
    const std::string_view name = status_name(status);
    return fmt::format(R"(<span class="pill {}">{}</span>)", name, name);
}

std::string image_html(std::string_view kind, std::string_view png, int width, int height,
                       std::string_view alternative) {
    return fmt::format(
        R"(<img class="{}" width="{}" height="{}" alt="{}" decoding="async" src="{}">)", kind,
        width, height, escaped(alternative), png_data_uri(png));
}

std::string material_anchor(const NamedMaterial& material) {
    return "material-" + escaped(material.name);
}

std::string margin_style(double error, double limit) {
    if (!(error <= limit)) return fmt::format("--hue:{}", kOverHue);
    const double share = std::clamp(error / limit, kGoodMargin, 1.0);
    const double near = 1.0 - std::log10(share) / std::log10(kGoodMargin);
    return fmt::format("--hue:{:.0f}", kGoodHue + (kNearHue - kGoodHue) * near);
}

Image picture(const QueryGrid& grid, const GridValues& values) {
    // A slice shows what light of irradiance pi would make, as the sphere's light does.
    const double exposure = grid.kernel == Kernel::slice ? std::numbers::pi : 1.0;
    std::vector<glm::dvec4> rows;
    rows.reserve(values.rows.size());
    for (const glm::vec4& row : values.rows) rows.push_back(exposure * glm::dvec4{row});
    return paint(grid, rows);
}

std::string reference_sphere_png(const CompareResult& result, std::size_t index, int shrink) {
    std::size_t grid_index = 0;
    const QueryGrid* grid = sphere_of(result, grid_index);
    if (grid == nullptr) return {};
    const Image image = shrunk(picture(*grid, result.reference_values[index][grid_index]), shrink);
    return encode_png(image.width, image.height, display_pixels(image));
}

}  // namespace lacquer
