// What the curves of a study run over, and curves over it.
#pragma once

#include <cmath>
#include <functional>
#include <string>

#include "markup/plot.h"

namespace lacquer::study {

struct Abscissa {
    const char* name;
    double from, to;
    bool logarithmic = false;

    // `share` in [0, 1].
    double at(double share) const {
        return logarithmic ? from * std::pow(to / from, share) : from + share * (to - from);
    }
};

inline constexpr Abscissa kCosine{"cos_theta_o", 0.01, 1.0};  // from next to grazing
inline constexpr Abscissa kEta{"eta", 1.0 / 3.0, 3.0, true};
inline constexpr Abscissa kTau{"tau", 0.05, 1.0};

// Axes without curves; the ordinate is from 0 to `top`.
Plot empty_plot(const std::string& title, const Abscissa& over, const std::string& quantity,
                double top);

Curve line(const std::string& label, const Abscissa& over,
           const std::function<double(double)>& value);

// The positions of simulated dots.
std::vector<double> dot_positions(const Abscissa& over);

}  // namespace lacquer::study
