// How relative errors are distributed, as curves in SVG.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compare/compare.h"

namespace lacquer {

// Counts of relative errors in bins of an eighth of a decade from 1e-10 to 1e-2; smaller and larger
// ones, and those that are not finite, count in the first and last bin.
class ErrorHistogram {
 public:
    static constexpr int kFirstDecade = -10;
    static constexpr int kLastDecade = -2;
    static constexpr int kBinsPerDecade = 8;
    static constexpr std::size_t kBins = (kLastDecade - kFirstDecade) * kBinsPerDecade;

    void add(float relative_error);
    void add(const MaterialResult& material);  // its kept values

    // Share of all errors in bin `index`, in [0, 1].
    double share(std::size_t index) const;
    std::uint64_t total() const { return total_; }

 private:
    std::array<std::uint64_t, kBins> counts_{};
    std::uint64_t total_ = 0;
};

// A small curve: errors to the right, shares (square root, so that tails are seen) upwards, and a
// line at the tolerance.
std::string histogram_sparkline(const ErrorHistogram& histogram, const Tolerance& tolerance);

struct NamedHistogram {
    std::string name;
    ErrorHistogram histogram;
};

// A large chart with one curve per histogram, logarithmic both ways, with a legend.
std::string histogram_chart(std::span<const NamedHistogram> histograms, const Tolerance& tolerance);

}  // namespace lacquer
