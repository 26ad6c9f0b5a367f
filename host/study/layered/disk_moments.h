// Energy, mean and width of light from the directions it takes, on the projected disk.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace lacquer::study {

// Light whose mean is in the plane of x.
struct Spread {
    double energy = 0.0, energy_error = 0.0;
    // Standard deviation per axis of the directions on the projected disk: 0.5 where they are
    // spread as by a Lambertian surface. 0 where there is no light.
    double width = 0.0, width_error = 0.0;
    double mean = 0.0, mean_error = 0.0;  // of their x
};

// Of positions on the disk at distance r from its middle: sums of weight times 1, x and r^2, and of
// squared weight times 1, x, x^2, r^2, r^2 x and r^4.
class DiskMoments {
 public:
    void add(double weight, const glm::dvec3& w);
    void merge(const DiskMoments& other);

    // With standard errors, of `count` walks, lost ones included.
    Spread spread(double count) const;

 private:
    std::array<double, 3> plain_{};
    std::array<double, 6> squared_{};
};

}  // namespace lacquer::study
