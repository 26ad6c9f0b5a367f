#include "reference/stack/equivalent_lobe_alpha.h"

namespace lacquer::reference {

double equivalent_lobe_alpha(const Microsurface& microsurface) {
    constexpr double kOffset = 0.425, kSlope = 0.15;
    const double alpha = 0.5 * (microsurface.alpha[0] + microsurface.alpha[1]);
    return microsurface.ndf == Ndf::ggx ? alpha : alpha * (kOffset + kSlope * alpha);
}

}  // namespace lacquer::reference
