// Curves as inline SVG.
#pragma once

#include <string>
#include <vector>

namespace lacquer::bake {

struct Curve {
    std::string label;  // empty: belongs to the curve before, in the same colour
    std::vector<double> x, y;
    bool dashed = false;
};

struct Plot {
    std::string title, x_label, y_label;
    double x_from = 0.0, x_to = 1.0, y_from = 0.0, y_to = 1.0;
    std::vector<Curve> curves;
};

// An <svg> element with axes, a grid, the curves and their labels.
std::string svg_of(const Plot& plot);

}  // namespace lacquer::bake
