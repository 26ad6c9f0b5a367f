#include "report/histogram.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "markup/markup.h"

namespace lacquer {

namespace {

using Histogram = ErrorHistogram;

constexpr double kDecades = Histogram::kLastDecade - Histogram::kFirstDecade;

// A drawing area in SVG units; `x` of an error, `y` of a height in [0, 1].
struct Frame {
    double left, top, width, height;

    double x(double relative_error) const {
        return left + width * (std::log10(relative_error) - Histogram::kFirstDecade) / kDecades;
    }
    // Heights below 0 land just below the frame, where they are cut off.
    double y(double unit) const { return top + height * (1.0 - std::clamp(unit, -0.1, 1.0)); }
    double bottom() const { return top + height; }
};

constexpr Frame kSparkline{0, 1, 160, 34};
constexpr Frame kChart{52, 12, 1000, 260};
constexpr int kChartDecades = 6;  // shares from 1e-6 to 1

// The outline of the bins, each `height_of` its share.
template <typename Height>
std::string outline(const Histogram& histogram, const Frame& frame, Height height_of) {
    std::string points;
    const double step = frame.width / double(Histogram::kBins);
    for (std::size_t i = 0; i < Histogram::kBins; ++i) {
        const double y = frame.y(height_of(histogram.share(i)));
        const double x = frame.left + step * double(i);
        points += fmt::format("{:.1f},{:.1f} {:.1f},{:.1f} ", x, y, x + step, y);
    }
    return points;
}

std::string vertical_line(const Frame& frame, double relative_error, std::string_view kind) {
    const double x = frame.x(relative_error);
    return fmt::format(R"(<line class="{}" x1="{:.1f}" x2="{:.1f}" y1="{:.1f}" y2="{:.1f}"/>)",
                       kind, x, x, frame.top, frame.bottom());
}

std::string power_label(double x, double y, int power, std::string_view anchor) {
    return fmt::format(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}">10)"
                       R"(<tspan dy="-5" class="power">{}</tspan></text>)",
                       x, y, anchor, power);
}

std::string chart_axes(const Frame& frame) {
    std::string axes;
    for (int power = Histogram::kFirstDecade; power <= Histogram::kLastDecade; ++power) {
        axes += vertical_line(frame, std::pow(10.0, power), "grid");
        axes += power_label(frame.x(std::pow(10.0, power)), frame.bottom() + 20, power, "middle");
    }
    for (int power = -kChartDecades; power <= 0; power += 2) {
        const double y = frame.y(1.0 + double(power) / kChartDecades);
        axes += fmt::format(R"(<line class="grid" x1="{}" x2="{}" y1="{:.1f}" y2="{:.1f}"/>)",
                            frame.left, frame.left + frame.width, y, y);
        axes += power_label(frame.left - 8, y + 4, power, "end");
    }
    return axes;
}

std::string tolerance_lines(const Frame& frame, const Tolerance& tolerance) {
    const auto label = [&](double error, std::string_view text) {
        return vertical_line(frame, error, "limit") +
               fmt::format(R"(<text class="limit-label" x="{:.1f}" y="{:.1f}">{}</text>)",
                           frame.x(error) + 6, frame.top + 12, text);
    };
    return label(tolerance.median_rel, "limit of the median") +
           label(tolerance.max_rel, "limit of the maximum");
}

}  // namespace

void ErrorHistogram::add(float relative_error) {
    const double decades = std::isfinite(relative_error)
                               ? std::log10(double{relative_error}) - kFirstDecade
                               : double{kLastDecade - kFirstDecade};
    const double bin = std::clamp(decades * kBinsPerDecade, 0.0, double(kBins - 1));
    ++counts_[static_cast<std::size_t>(bin)];
    ++total_;
}

void ErrorHistogram::add(const MaterialResult& material) {
    for (const GridValues& values : material.values)
        for (const float error : values.relative_errors) add(error);
}

double ErrorHistogram::share(std::size_t index) const {
    return total_ == 0 ? 0.0 : double(counts_[index]) / double(total_);
}

std::string histogram_sparkline(const ErrorHistogram& histogram, const Tolerance& tolerance) {
    const Frame& frame = kSparkline;
    double most = 0.0;
    for (std::size_t i = 0; i < Histogram::kBins; ++i) most = std::max(most, histogram.share(i));
    const auto height = [most](double share) { return most > 0.0 ? std::sqrt(share / most) : 0.0; };
    return fmt::format(
        R"(<svg class="spark" viewBox="0 0 160 36" preserveAspectRatio="none" role="img"
aria-label="Distribution of relative errors">
<polygon points="{0:.1f},{1:.1f} {2}{3:.1f},{1:.1f}"/>{4}</svg>)",
        frame.left, frame.bottom(), outline(histogram, frame, height), frame.left + frame.width,
        vertical_line(frame, tolerance.max_rel, "limit"));
}

std::string histogram_chart(std::span<const NamedHistogram> histograms,
                            const Tolerance& tolerance) {
    const Frame& frame = kChart;
    const auto height = [](double share) {
        return share > 0.0 ? 1.0 + std::log10(share) / kChartDecades : -1.0;
    };
    std::string curves, legend;
    for (std::size_t i = 0; i < histograms.size(); ++i) {
        curves += fmt::format(R"(<polyline class="s{}" points="{}"/>)", i % 10,
                              outline(histograms[i].histogram, frame, height));
        legend += fmt::format(R"(<li><span class="swatch s{}"></span>{}</li>)", i % 10,
                              escaped(histograms[i].name));
    }
    return fmt::format(
        R"(<figure class="chart"><svg viewBox="0 0 1064 318" role="img"
aria-label="Distribution of relative errors per backend">
<clipPath id="plot"><rect x="{}" y="{}" width="{}" height="{}"/></clipPath>
{}<g clip-path='url(#plot)'>{}</g>{}<text class="axis" x="552" y="314"
text-anchor="middle">relative error</text></svg><ul class="legend">{}</ul></figure>)",
        frame.left, frame.top - 1, frame.width, frame.height + 2, chart_axes(frame), curves,
        tolerance_lines(frame, tolerance), legend);
}

}  // namespace lacquer
