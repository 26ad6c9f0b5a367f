// The middle of several measurements.
#pragma once

#include <algorithm>
#include <vector>

namespace lacquer {

// The upper of the two in the middle where there is an even number; `values` not empty.
inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace lacquer
