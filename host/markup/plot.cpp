#include "markup/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "markup/markup.h"

namespace lacquer {

namespace {

constexpr double kWidth = 380, kHeight = 260;
constexpr double kLeft = 46, kRight = 92, kTop = 26, kBottom = 36;  // margins
constexpr double kDotRadius = 2.3;
constexpr std::array<const char*, 7> kColors{"#3a86c8", "#d4573f", "#3ba35a", "#9a63b5",
                                             "#c08a10", "#46a0a3", "#80807c"};

// One axis: a value's place between its ends, in [0, 1].
struct Scale {
    double from, to;
    bool logarithmic;

    double place(double value) const {
        if (!logarithmic) return (value - from) / (to - from);
        return std::log(std::max(value, from) / from) / std::log(to / from);
    }

    std::vector<double> ticks() const {
        std::vector<double> values;
        if (!logarithmic) {
            constexpr int kTicks = 5;
            for (int tick = 0; tick <= kTicks; ++tick)
                values.push_back(from + (to - from) * tick / kTicks);
            return values;
        }
        constexpr double kRounding = 1e-9;
        for (double decade = std::pow(10.0, std::floor(std::log10(from))); decade <= to;
             decade *= 10.0)
            for (const double digit : {1.0, 2.0, 5.0})
                if (const double value = digit * decade;
                    value >= from * (1.0 - kRounding) && value <= to * (1.0 + kRounding))
                    values.push_back(value);
        return values;
    }
};

Scale x_scale(const Plot& plot) {
    return {plot.x_from, plot.x_to, plot.x_logarithmic};
}

Scale y_scale(const Plot& plot) {
    return {plot.y_from, plot.y_to, plot.y_logarithmic};
}

double x_of(const Plot& plot, double x) {
    return kLeft + x_scale(plot).place(x) * (kWidth - kLeft - kRight);
}

double y_of(const Plot& plot, double y) {
    return kHeight - kBottom -
           std::clamp(y_scale(plot).place(y), 0.0, 1.0) * (kHeight - kTop - kBottom);
}

std::string axes_of(const Plot& plot) {
    std::string svg;
    for (const double x : x_scale(plot).ticks())
        svg += fmt::format(
            R"(<path class="grid" d="M{0:.1f} {1}V{2}"/><text x="{0:.1f}" y="{3}" text-anchor="middle">{4:.2g}</text>)",
            x_of(plot, x), kTop, kHeight - kBottom, kHeight - kBottom + 14, x);
    for (const double y : y_scale(plot).ticks())
        svg += fmt::format(
            R"(<path class="grid" d="M{0} {1:.1f}H{2}"/><text x="{3}" y="{4:.1f}" text-anchor="end">{5:.2g}</text>)",
            kLeft, y_of(plot, y), kWidth - kRight, kLeft - 5, y_of(plot, y) + 4, y);
    svg +=
        fmt::format(R"(<text x="{}" y="16" class="title">{}</text>)", kLeft, escaped(plot.title));
    svg += fmt::format(R"(<text x="{}" y="{}" text-anchor="middle">{}</text>)",
                       0.5 * (kLeft + kWidth - kRight), kHeight - 6, escaped(plot.x_label));
    svg += fmt::format(
        R"svg(<text transform="translate(12 {}) rotate(-90)" text-anchor="middle">{}</text>)svg",
        0.5 * kHeight, escaped(plot.y_label));
    return svg;
}

std::string line_of(const Plot& plot, const Curve& curve, const char* color) {
    std::string path;
    for (std::size_t n = 0; n < curve.x.size(); ++n)
        path += fmt::format("{}{:.1f} {:.1f}", n == 0 ? "M" : "L", x_of(plot, curve.x[n]),
                            y_of(plot, curve.y[n]));
    return fmt::format(R"(<path class="curve" stroke="{}"{} d="{}"/>)", color,
                       curve.dashed ? R"( stroke-dasharray="5 3")" : "", path);
}

std::string dots_of(const Plot& plot, const Curve& curve, const char* color) {
    std::string svg;
    for (std::size_t n = 0; n < curve.x.size(); ++n) {
        const double x = x_of(plot, curve.x[n]);
        svg += fmt::format(R"(<circle fill="{}" r="{}" cx="{:.1f}" cy="{:.1f}"/>)", color,
                           kDotRadius, x, y_of(plot, curve.y[n]));
        if (curve.errors.empty()) continue;
        svg += fmt::format(R"(<path class="bar" stroke="{}" d="M{:.1f} {:.1f}V{:.1f}"/>)", color, x,
                           y_of(plot, curve.y[n] - curve.errors[n]),
                           y_of(plot, curve.y[n] + curve.errors[n]));
    }
    return svg;
}

// `index` counts labelled curves: one without a label has the colour of the one before.
std::string curve_of(const Plot& plot, const Curve& curve, std::size_t index) {
    const char* color = kColors[index % kColors.size()];
    std::string svg = curve.dots ? dots_of(plot, curve, color) : line_of(plot, curve, color);
    if (!curve.label.empty())
        svg +=
            fmt::format(R"(<text x="{}" y="{:.1f}" style="fill:{}">{}</text>)", kWidth - kRight + 6,
                        kTop + 8 + 14.0 * static_cast<double>(index), color, escaped(curve.label));
    return svg;
}

std::string backdrop_of(const Plot& plot) {
    if (plot.backdrop.empty()) return {};
    return fmt::format(
        R"(<image x="{}" y="{}" width="{}" height="{}" preserveAspectRatio="none" href="{}"/>)",
        kLeft, kTop, kWidth - kLeft - kRight, kHeight - kTop - kBottom, plot.backdrop);
}

}  // namespace

std::string svg_of(const Plot& plot) {
    std::string svg = fmt::format(
        R"(<svg class="plot" viewBox="0 0 {0} {1}" width="{0}" height="{1}" role="img" aria-label="{2}">)",
        kWidth, kHeight, escaped(plot.title));
    svg += axes_of(plot) + backdrop_of(plot);
    std::string dots;  // over all lines
    std::size_t labelled = 0;
    for (const Curve& curve : plot.curves) {
        if (!curve.label.empty()) ++labelled;
        (curve.dots ? dots : svg) += curve_of(plot, curve, labelled == 0 ? 0 : labelled - 1);
    }
    return svg + dots + "</svg>";
}

}  // namespace lacquer
