// Pictures of relative errors: one logarithmic scale for all of them, so that they can be compared.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compare/grids.h"
#include "image/display.h"

namespace lacquer {

// Four decades below the limit, in steps of an eighth of a decade. What is smaller has the darkest
// colour, what exceeds the limit a colour of its own.
class HeatScale {
 public:
    static constexpr int kDecades = 4;
    static constexpr int kStepsPerDecade = 8;
    static constexpr int kSteps = kDecades * kStepsPerDecade;

    // `limit` is the relative error that must not be exceeded, above 0.
    explicit HeatScale(double limit);

    double limit() const { return limit_; }

    // Palette: nothing computed, the steps from small to large, over the limit, not a number.
    const std::vector<DisplayColor>& palette() const { return palette_; }
    std::uint8_t index_of(float relative_error) const;

    static constexpr std::uint8_t kNothing = 0;
    static constexpr std::uint8_t kFirstStep = 1;
    static constexpr std::uint8_t kOver = kFirstStep + kSteps;
    static constexpr std::uint8_t kNotFinite = kOver + 1;

 private:
    double limit_;
    std::vector<DisplayColor> palette_;
};

inline constexpr DisplayColor kOverLimitColor{0, 229, 255, 255};

// A grid and the relative error of each of its queries.
struct HeatTile {
    const QueryGrid* grid;
    std::span<const float> relative_errors;
};

// A PNG of tiles of equal size, side by side.
std::string heat_png(const HeatScale& scale, std::span<const HeatTile> tiles);

}  // namespace lacquer
