#include "tables/axis.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lacquer {

namespace {

// A parabola from (0, 0) to (1, 1) and its inverse. Its slope at 0 keeps rounded values near `from`
// from moving by much more than they were rounded by.
constexpr double kSlope = 0.02;

double bent(double t) {
    return t * (t + kSlope) / (1.0 + kSlope);
}

double straightened(double u) {
    const double discriminant = kSlope * kSlope + 4.0 * (1.0 + kSlope) * u;
    return 0.5 * (std::sqrt(std::max(discriminant, 0.0)) - kSlope);
}

}  // namespace

std::string_view mapping_name(Mapping mapping) {
    switch (mapping) {
        case Mapping::index:
            return "index";
        case Mapping::linear:
            return "linear";
        case Mapping::squared:
            return "squared";
        case Mapping::log_bent:
            return "log_bent";
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
        case Mapping::log_bent:
            return axis.from * std::pow(axis.to / axis.from, bent(t));
        default:
            return axis.from + (axis.to - axis.from) * t;
    }
}

double axis_position(const Axis& axis, double value) {
    double t = (value - axis.from) / (axis.to - axis.from);
    if (axis.mapping == Mapping::squared) t = std::sqrt(std::max(t, 0.0));
    if (axis.mapping == Mapping::log_bent)
        t = straightened(std::log(value / axis.from) / std::log(axis.to / axis.from));
    return std::clamp(t, 0.0, 1.0) * static_cast<double>(axis.size - 1);
}

}  // namespace lacquer
