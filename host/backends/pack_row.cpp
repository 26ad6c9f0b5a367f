#include "backends/pack_row.h"

#include <algorithm>
#include <limits>

namespace lacquer {

glm::vec4 facets_row(const Microsurface& facets, double third) {
    return {facets.alpha[0], facets.alpha[1], third, facets.ndf == Ndf::beckmann ? 1.0 : 0.0};
}

glm::vec4 colour_row(const Rgb& colour, double fourth) {
    constexpr double kLargest = std::numeric_limits<float>::max();
    return {std::min(colour[0], kLargest), std::min(colour[1], kLargest),
            std::min(colour[2], kLargest), fourth};
}

}  // namespace lacquer
