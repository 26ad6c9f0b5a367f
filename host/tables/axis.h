// The axes of tables: which value of a parameter each node stands for.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace lacquer {

// Where the nodes of an axis lie. t runs from 0 at the first node to 1 at the last.
enum class Mapping {
    index,     // counts channels; not a parameter
    linear,    // from + (to - from) t
    squared,   // from + (to - from) t^2: dense near `from`
    log_bent,  // from * (to / from)^(t (t + 0.02) / 1.02): dense near `from`, a finite slope there
};

std::string_view mapping_name(Mapping mapping);

struct Axis {
    std::string name;  // "alpha", "eta", ...
    Mapping mapping = Mapping::index;
    std::size_t size = 0;
    double from = 0.0, to = 0.0;
    std::string unit = "1";

    bool operator==(const Axis&) const = default;
};

// The value of a parameter at a node.
double axis_value(const Axis& axis, std::size_t node);

// Position in [0, size - 1] of a value among the nodes; values beyond the ends are the ends'.
double axis_position(const Axis& axis, double value);

}  // namespace lacquer
