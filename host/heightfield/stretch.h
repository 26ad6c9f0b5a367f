// Makes the heights of a surface steeper or flatter stratum by stratum, without breaking it.
// Based on: d'Eon et al. 2023, Microfacet Theory for Non-Uniform Heightfields, section 3.3
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace lacquer::heightfield {

// A range of heights: its share of the area, and what slopes in it are multiplied by.
struct StretchedStratum {
    double weight = 1.0;
    double factor = 1.0;  // at least 0, which makes a plateau
};

// A continuous function of height, linear within each stratum.
class Stretch {
 public:
    // `strata` from the top down, their weights together 1; the boundaries are quantiles of
    // `heights`. Throws Error for a stratum so thin that no height falls into it.
    Stretch(std::span<const StretchedStratum> strata, std::span<const double> heights);

    // The stratum of a height, 0 the topmost.
    std::size_t stratum(double height) const;

    double operator()(double height) const;

    // From the top down, one fewer than there are strata.
    std::span<const double> boundaries() const { return boundaries_; }
    double factor(std::size_t stratum) const { return factors_[stratum]; }

 private:
    std::vector<double> boundaries_;
    std::vector<double> factors_;
    std::vector<double> stretched_;  // the boundaries' heights after stretching
};

}  // namespace lacquer::heightfield
