// Curves and maps as inline SVG.
#pragma once

#include <string>
#include <vector>

namespace lacquer {

struct Curve {
    std::string label;  // empty: belongs to the curve before, in the same colour
    std::vector<double> x{}, y{};
    bool dashed = false;
    bool dots = false;             // a dot per point in place of a line
    std::vector<double> errors{};  // half the length of each dot's error bar; empty: no bars
    std::string color{};           // CSS; empty: the next of the plot's own
};

struct Plot {
    std::string title, x_label, y_label;
    double x_from = 0.0, x_to = 1.0, y_from = 0.0, y_to = 1.0;
    std::vector<Curve> curves{};
    bool x_logarithmic = false, y_logarithmic = false;
    std::string backdrop{};  // address of a picture that fills the frame; empty: none
};

// An <svg> element with axes, a grid, the curves and their labels. Needs the classes of
// kPlotStyle.
std::string svg_of(const Plot& plot);

// Rules for a style sheet that defines the colours --ink, --soft and --line.
inline constexpr const char* kPlotStyle =
    R"css(.plot text{font-size:11px;fill:var(--soft)}.plot .title{font-size:13px;font-weight:600;fill:var(--ink)}
.plot .grid{stroke:var(--line)}.plot .curve{fill:none;stroke-width:1.6}.plot .bar{stroke-width:1}
.plot image{image-rendering:pixelated}
)css";

}  // namespace lacquer
