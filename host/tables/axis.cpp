#include "tables/axis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lacquer {

std::string_view mapping_name(Mapping mapping) {
    switch (mapping) {
        case Mapping::index:
            return "index";
        case Mapping::linear:
            return "linear";
        case Mapping::squared:
            return "squared";
        case Mapping::log_square:
            return "log_square";
    }
    return {};
}

double axis_value(const Axis& axis, std::size_t node) {
    assert(node < axis.size);
    if (axis.mapping == Mapping::index) return static_cast<double>(node);
    const double t =
        axis.size > 1 ? static_cast<double>(node) / static_cast<double>(axis.size - 1) : 0.0;
    switch (axis.mapping) {
        case Mapping::squared:
            return axis.from + (axis.to - axis.from) * t * t;
        case Mapping::log_square:
            return axis.from * std::pow(axis.to / axis.from, t * t);
        default:
            return axis.from + (axis.to - axis.from) * t;
    }
}

double axis_position(const Axis& axis, double value) {
    double t = (value - axis.from) / (axis.to - axis.from);
    if (axis.mapping == Mapping::squared) t = std::sqrt(std::max(t, 0.0));
    if (axis.mapping == Mapping::log_square)
        t = std::sqrt(std::max(std::log(value / axis.from) / std::log(axis.to / axis.from), 0.0));
    return std::clamp(t, 0.0, 1.0) * static_cast<double>(axis.size - 1);
}

}  // namespace lacquer
