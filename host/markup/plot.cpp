#include "markup/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "markup/markup.h"

namespace lacquer {

namespace {

constexpr double kWidth = 380, kHeight = 260;
constexpr double kLeft = 54, kRight = 92, kTop = 26, kBottom = 36;  // margins
constexpr double kDotRadius = 2.3;
constexpr std::array<const char*, 7> kColors{"#3a86c8", "#d4573f", "#3ba35a", "#9a63b5",
                                             "#c08a10", "#46a0a3", "#80807c"};

// One axis: a value's place between its ends, in [0, 1].
class Scale {
 public:
    Scale(double low, double high, bool is_logarithmic)
        : from_{low}, to_{high}, logarithmic_{is_logarithmic} {}

    double place(double value) const {
        if (!logarithmic_) return (value - from_) / (to_ - from_);
        return std::log(std::max(value, from_) / from_) / std::log(to_ / from_);
    }

    std::vector<double> ticks() const {
        std::vector<double> values;
        if (!logarithmic_) {
            const double step = tick_step();
            const auto count = static_cast<int>(std::floor((to_ - from_) / step + kRounding));
            for (int tick = 0; tick <= count; ++tick) values.push_back(from_ + tick * step);
            return values;
        }
        const bool only_decades = to_ / from_ > 101.0;
        for (int power = -12; power <= 12; ++power)
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double value = digit * std::pow(10.0, power);
                const bool is_inside =
                    value >= from_ * (1.0 - kRounding) && value <= to_ * (1.0 + kRounding);
                if (is_inside && !(only_decades && digit > 1.0)) values.push_back(value);
            }
        return values;
    }

 private:
    static constexpr double kRounding = 1e-9;

    // 1, 2, 2.5 or 5 times a power of ten, for four to seven steps.
    double tick_step() const {
        const double decade = std::pow(10.0, std::floor(std::log10((to_ - from_) / 4.0)));
        double step = decade;
        for (const double digit : {2.0, 2.5, 5.0})
            if (digit * decade <= (to_ - from_) / 4.0) step = digit * decade;
        return step;
    }

    double from_, to_;
    bool logarithmic_;
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
            R"(<path class="grid" d="M{0:.1f} {1}V{2}"/><text x="{0:.1f}" y="{3}" text-anchor="middle">{4:.3g}</text>)",
            x_of(plot, x), kTop, kHeight - kBottom, kHeight - kBottom + 14, x);
    for (const double y : y_scale(plot).ticks())
        svg += fmt::format(
            R"(<path class="grid" d="M{0} {1:.1f}H{2}"/><text x="{3}" y="{4:.1f}" text-anchor="end">{5:.3g}</text>)",
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

std::string line_of(const Plot& plot, const Curve& curve, const std::string& color) {
    std::string path;
    for (std::size_t n = 0; n < curve.x.size(); ++n)
        path += fmt::format("{}{:.1f} {:.1f}", n == 0 ? "M" : "L", x_of(plot, curve.x[n]),
                            y_of(plot, curve.y[n]));
    return fmt::format(R"(<path class="curve" stroke="{}"{} d="{}"/>)", color,
                       curve.dashed ? R"( stroke-dasharray="5 3")" : "", path);
}

std::string dots_of(const Plot& plot, const Curve& curve, const std::string& color) {
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
    const std::string color = curve.color.empty() ? kColors[index % kColors.size()] : curve.color;
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
