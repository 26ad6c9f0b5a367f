#include "reference/stack/adding.h"

#include <glm/common.hpp>

namespace lacquer::reference {

namespace {

constexpr double kLeastLoss = 1e-4;  // per round trip, which keeps the series finite

// The sum of all powers of what is left after a round trip.
Energy series(const Energy& ratio) {
    return Energy{1.0} / glm::max(Energy{1.0} - ratio, Energy{kLeastLoss});
}

}  // namespace

StackShares add_up(const std::vector<InterfaceShares>& interfaces, const Energy& base,
                   bool base_reflects) {
    const std::size_t count = interfaces.size();
    const Energy none{0.0};
    // All that is below a medium and all that is above it, as mirrors of light about to cross it.
    std::vector<Energy> below(count + 1, none), above(count + 1, none);
    below[count] = base_reflects ? base : none;
    for (std::size_t n = count; n-- > 0;) {
        const InterfaceShares& at = interfaces[n];
        below[n] = at.reflected_down + at.transmitted_down * below[n + 1] * at.transmitted_up *
                                           series(below[n + 1] * at.reflected_up);
    }
    StackShares shares{std::vector<Energy>(count + 1, none), std::vector<Energy>(count + 1, none)};
    Energy leaving{1.0};  // of light about to cross the medium upwards
    for (std::size_t n = 1; n <= count; ++n) {
        const InterfaceShares& at = interfaces[n - 1];
        leaving *= at.transmitted_up * series(at.reflected_up * below[n]);
        shares.escaping[n] = below[n] * leaving;
        above[n] = at.reflected_up + at.transmitted_up * above[n - 1] * at.transmitted_down *
                                         series(above[n - 1] * at.reflected_down);
    }
    if (base_reflects) return shares;
    shares.arriving[count] = base;
    for (std::size_t n = count; n-- > 1;) {
        const InterfaceShares& at = interfaces[n];
        shares.arriving[n] =
            at.transmitted_down * shares.arriving[n + 1] * series(at.reflected_down * above[n]);
    }
    shares.returning = above[count] * base;
    return shares;
}

}  // namespace lacquer::reference
