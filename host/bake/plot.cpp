#include "bake/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace lacquer::bake {

namespace {

constexpr double kWidth = 380, kHeight = 260;
constexpr double kLeft = 46, kRight = 92, kTop = 26, kBottom = 36;  // margins
constexpr int kTicks = 5;
constexpr std::array<const char*, 7> kColors{"#3a86c8", "#d4573f", "#3ba35a", "#9a63b5",
                                             "#c08a10", "#46a0a3", "#80807c"};

double x_of(const Plot& plot, double x) {
    return kLeft + (x - plot.x_from) / (plot.x_to - plot.x_from) * (kWidth - kLeft - kRight);
}

double y_of(const Plot& plot, double y) {
    const double clipped = std::clamp(y, plot.y_from, plot.y_to);
    return kHeight - kBottom -
           (clipped - plot.y_from) / (plot.y_to - plot.y_from) * (kHeight - kTop - kBottom);
}

std::string axes_of(const Plot& plot) {
    std::string svg;
    for (int tick = 0; tick <= kTicks; ++tick) {
        const double share = static_cast<double>(tick) / kTicks;
        const double x = plot.x_from + share * (plot.x_to - plot.x_from);
        const double y = plot.y_from + share * (plot.y_to - plot.y_from);
        svg += fmt::format(
            R"(<path class="grid" d="M{0:.1f} {1}V{2}"/><text x="{0:.1f}" y="{3}" text-anchor="middle">{4:.2g}</text>)",
            x_of(plot, x), kTop, kHeight - kBottom, kHeight - kBottom + 14, x);
        svg += fmt::format(
            R"(<path class="grid" d="M{0} {1:.1f}H{2}"/><text x="{3}" y="{4:.1f}" text-anchor="end">{5:.2g}</text>)",
            kLeft, y_of(plot, y), kWidth - kRight, kLeft - 5, y_of(plot, y) + 4, y);
    }
    svg += fmt::format(R"(<text x="{}" y="16" class="title">{}</text>)", kLeft, plot.title);
    svg += fmt::format(R"(<text x="{}" y="{}" text-anchor="middle">{}</text>)",
                       0.5 * (kLeft + kWidth - kRight), kHeight - 6, plot.x_label);
    svg += fmt::format(
        R"svg(<text transform="translate(12 {}) rotate(-90)" text-anchor="middle">{}</text>)svg",
        0.5 * kHeight, plot.y_label);
    return svg;
}

// `index` counts labelled curves: one without a label has the colour of the one before.
std::string curve_of(const Plot& plot, const Curve& curve, std::size_t index) {
    const char* color = kColors[index % kColors.size()];
    std::string path;
    for (std::size_t n = 0; n < curve.x.size(); ++n)
        path += fmt::format("{}{:.1f} {:.1f}", n == 0 ? "M" : "L", x_of(plot, curve.x[n]),
                            y_of(plot, curve.y[n]));
    std::string svg = fmt::format(R"(<path class="curve" stroke="{}"{} d="{}"/>)", color,
                                  curve.dashed ? R"( stroke-dasharray="5 3")" : "", path);
    if (!curve.label.empty())
        svg +=
            fmt::format(R"(<text x="{}" y="{:.1f}" style="fill:{}">{}</text>)", kWidth - kRight + 6,
                        kTop + 8 + 14.0 * static_cast<double>(index), color, curve.label);
    return svg;
}

}  // namespace

std::string svg_of(const Plot& plot) {
    std::string svg = fmt::format(
        R"(<svg viewBox="0 0 {0} {1}" width="{0}" height="{1}" role="img" aria-label="{2}">)",
        kWidth, kHeight, plot.title);
    svg += axes_of(plot);
    std::size_t labelled = 0;
    for (const Curve& curve : plot.curves) {
        if (!curve.label.empty()) ++labelled;
        svg += curve_of(plot, curve, labelled == 0 ? 0 : labelled - 1);
    }
    return svg + "</svg>";
}

}  // namespace lacquer::bake
