// How far each backend may be from the reference: the one place where that is said.
#pragma once

#include <string_view>

#include "core/model.h"

namespace lacquer {

// Limits on the relative errors over the queries of one material, see compare/metrics.h. A result
// that is not finite exceeds every limit.
struct Tolerance {
    double max_rel;
    double median_rel;
};

// The median is that of a formula free of cancellation. One rounding to float is off by at most
// u = 2^-24 = 6.0e-8; a value of the BRDF comes from some 50 roundings, whose errors add like a
// random walk, sqrt(50) u / sqrt(3) = 2.4e-7 for the spread of uniform roundings. 3e-7 leaves room
// for the last digit of a language's own square root and division (2.5 u each in Vulkan and WGSL).
//
// The maximum is that of the worst-conditioned place: the flank of a narrow lobe, where the
// distribution answers to the slope t of the microfacet normal with d ln D / dt = 4 t / (a^2 + t^2)
// <= 2 / a. The slope carries about 4 u of absolute error, so that a = 5e-3, narrower than any
// bundled material, gives 9.5e-5.
inline constexpr Tolerance kFloatTolerance{1e-4, 3e-7};

// Light of a stack meets an interface some ten times before it leaves (five layers down and up),
// each time through some 35 roundings more: sqrt(50 + 10 * 35) u / sqrt(3) = 6.9e-7.
inline constexpr Tolerance kStackTolerance{1e-4, 7e-7};

// Lobes that light and viewer share have that light by way of cubics, and factors of either
// direction: some 90 roundings more, sqrt(50 + 10 * 35 + 90) u / sqrt(3) = 7.6e-7.
inline constexpr Tolerance kSymmetricStackTolerance{1e-4, 7.6e-7};

// What meets several facets of a microsurface is a polynomial of seven terms for each direction, in
// two planes: some 30 roundings more for either, sqrt(50 + 2 * 30) u / sqrt(3) = 3.6e-7. On smooth
// facets its terms, up to 0.2, cancel to as little as 6e-4 away from grazing, which counts where the
// average is as little (LQ_LEAST_SEVERAL_AVERAGE): two roundings a term are 14 u 0.2 / 6e-4 = 2.8e-4.
inline constexpr Tolerance kCompensatedTolerance{3e-4, 3.6e-7};

// The tolerance of a model on the backend of that name: a language or a model that needs more is a
// formula to mend, or a reason to be written here.
constexpr Tolerance tolerance_of(std::string_view /*backend*/, Model model) {
    if (model == Model::microsurface_compensated) return kCompensatedTolerance;
    if (model == Model::stack_symmetric) return kSymmetricStackTolerance;
    return model == Model::stack ? kStackTolerance : kFloatTolerance;
}

}  // namespace lacquer
