#include "heightfield/stretch.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/error.h"

namespace lacquer::heightfield {

namespace {

// Halfway between two of the sorted heights, so that it is none of them.
double boundary_below(std::size_t above, std::vector<double>& heights) {
    const auto next = heights.begin() + static_cast<std::ptrdiff_t>(above);
    std::nth_element(heights.begin(), next, heights.end(), std::greater{});
    const double last = *std::min_element(heights.begin(), next);
    return 0.5 * (last + *next);
}

}  // namespace

Stretch::Stretch(std::span<const StretchedStratum> strata, std::span<const double> heights) {
    std::vector<double> sorted{heights.begin(), heights.end()};
    std::size_t above = 0;
    double share = 0.0;
    for (std::size_t n = 0; n < strata.size(); ++n) {
        share += strata[n].weight;
        const bool last = n + 1 == strata.size();
        const std::size_t until =
            last ? sorted.size()
                 : static_cast<std::size_t>(std::llround(share * double(sorted.size())));
        if (until <= above || until > sorted.size() || (!last && until == sorted.size()))
            throw Error{fmt::format(
                "stratum {} has the weight {}, less than one of the heightfield's {} heights", n,
                strata[n].weight, sorted.size())};
        above = until;
        factors_.push_back(strata[n].factor);
        if (!last) boundaries_.push_back(boundary_below(above, sorted));
    }
    // The topmost boundary stays where it is: heights count from there.
    for (std::size_t n = 0; n < boundaries_.size(); ++n)
        stretched_.push_back(n == 0 ? boundaries_[0]
                                    : stretched_[n - 1] +
                                          factors_[n] * (boundaries_[n] - boundaries_[n - 1]));
}

std::size_t Stretch::stratum(double height) const {
    std::size_t index = 0;
    while (index < boundaries_.size() && height < boundaries_[index]) ++index;
    return index;
}

double Stretch::operator()(double height) const {
    if (boundaries_.empty()) return factors_[0] * height;
    const std::size_t index = stratum(height);
    const std::size_t anchor = index == 0 ? 0 : index - 1;
    return stretched_[anchor] + factors_[index] * (height - boundaries_[anchor]);
}

}  // namespace lacquer::heightfield
