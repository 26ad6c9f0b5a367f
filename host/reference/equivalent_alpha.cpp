#include "reference/equivalent_alpha.h"

namespace lacquer::reference {

namespace {

// GGX roughness over Beckmann's: offset + slope * alpha.
struct RoughnessRatio {
    double offset, slope;
};

constexpr RoughnessRatio kThinner{0.52, 0.41};  // eta < 1, where tails blur the critical angle
constexpr RoughnessRatio kDenser{0.52, 0.09};

}  // namespace

double equivalent_ggx_alpha(const Microsurface& microsurface, double eta) {
    const double alpha = 0.5 * (microsurface.alpha[0] + microsurface.alpha[1]);
    if (microsurface.ndf == Ndf::ggx) return alpha;
    const auto& [offset, slope] = eta < 1.0 ? kThinner : kDenser;
    return alpha * (offset + slope * alpha);
}

}  // namespace lacquer::reference
