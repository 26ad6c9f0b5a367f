// What brings the albedo of a symmetric lobe (symmetric.h) to the light that the lobe should have:
// a factor b of the cosine of either direction. Alone, lobes at grazing angles take their light
// from directions for which the stack reflects more, and none has what meets several facets.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

#include "reference/stack/fitted_light.h"

namespace lacquer::reference {

// Linear between its nodes and constant beyond; finer at grazing angles, where it bends.
struct Balance {
    static constexpr std::array<double, 5> kNodes{0.05, 0.15, 0.35, 0.65, 1.0};
    std::array<glm::dvec3, kNodes.size()> known = ones();

    // At `cosine` in [0, 1].
    glm::dvec3 at(double cosine) const;

 private:
    static constexpr std::array<glm::dvec3, kNodes.size()> ones() {
        std::array<glm::dvec3, kNodes.size()> all{};
        all.fill(glm::dvec3{1.0});
        return all;
    }
};

// What the top interface lets in on the way to the lobe and back: the geometric mean of both
// directions, above the surface.
double entering_both_ways(const StackInterface& top, const glm::dvec3& wi, const glm::dvec3& wo);

Balance fit_balance(const StackInterface& top, const FittedLobe& lobe);

}  // namespace lacquer::reference
