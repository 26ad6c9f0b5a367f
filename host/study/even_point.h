// Points that fill the unit cube evenly.
// Based on: Roberts 2018, The Unreasonable Effectiveness of Quasirandom Sequences
#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace lacquer::study {

inline glm::dvec3 even_point(int index) {
    constexpr double kGrowth = 1.2207440846057596;  // the root of x^4 = x + 1
    const auto coordinate = [index](double step) {
        const double value = 0.5 + index * step;
        return value - std::floor(value);
    };
    return {coordinate(1.0 / kGrowth), coordinate(1.0 / (kGrowth * kGrowth)),
            coordinate(1.0 / (kGrowth * kGrowth * kGrowth))};
}

}  // namespace lacquer::study
