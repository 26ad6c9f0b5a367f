// Random stacks for the model `stack`: one to four layers, a third of whose media scatter, over any
// base; every fourth microsurface is smooth.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <random>

#include "lacquer/material.h"

namespace lacquer::test {

class RandomStacks {
 public:
    struct Range {
        std::uint64_t seed;
        double least_g;            // of media that scatter, in [-1, 0.95]
        bool with_beckmann;        // every fourth microsurface
        bool with_blends = false;  // every second interface: of two to four strata
    };

    explicit RandomStacks(const Range& range);

    double uniform(double low, double high);

    // Three numbers in [0, 1).
    glm::dvec3 numbers();

    Material next();

    // A unit vector above the surface.
    glm::dvec3 direction(double least_cosine);

 private:
    Roughness roughness();
    Microsurface facets();
    Rgb rgb(double low, double high);

    Range range_;
    std::mt19937_64 random_;
};

}  // namespace lacquer::test
