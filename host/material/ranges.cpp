#include "material/ranges.h"

#include <fmt/format.h>

namespace lacquer {

bool NumberRange::contains(double value) const {
    return open ? value > low && value < high : value >= low && value <= high;
}

std::string NumberRange::text() const {
    return open ? fmt::format("({:.6g}, {:.6g})", low, high)
                : fmt::format("[{:.6g}, {:.6g}]", low, high);
}

bool is_ior_ratio_allowed(double below, double above) {
    const double ratio = below / above;
    return ratio >= kIorRatioRange.low * (1.0 - kRatioSlack) &&
           ratio <= kIorRatioRange.high * (1.0 + kRatioSlack);
}

}  // namespace lacquer
