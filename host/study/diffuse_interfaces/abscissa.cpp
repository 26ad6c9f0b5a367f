#include "study/diffuse_interfaces/abscissa.h"

namespace lacquer::study {

Plot empty_plot(const std::string& title, const Abscissa& over, const std::string& quantity,
                double top) {
    Plot plot{title, over.name, quantity, over.logarithmic ? over.from : 0.0, over.to, 0.0, top};
    plot.x_logarithmic = over.logarithmic;
    return plot;
}

Curve line(const std::string& label, const Abscissa& over,
           const std::function<double(double)>& value) {
    constexpr int kPoints = 120;
    Curve curve{label};
    for (int n = 0; n <= kPoints; ++n) {
        curve.x.push_back(over.at(double(n) / kPoints));
        curve.y.push_back(value(curve.x.back()));
    }
    return curve;
}

std::vector<double> dot_positions(const Abscissa& over) {
    constexpr int kDots = 13;
    std::vector<double> positions;
    for (int n = 0; n < kDots; ++n) positions.push_back(over.at(double(n) / (kDots - 1)));
    return positions;
}

}  // namespace lacquer::study
