// A function of direction as a polynomial in the root of its cosine, through values at the zeros of
// T_7(2 x - 1), x = sqrt(cos_theta): near grazing, where masking changes fastest, zeros are dense.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

namespace lacquer::reference {

inline constexpr std::size_t kAlbedoNodes = 7;

// The cosine at a node; in (0, 1).
double albedo_node_cosine(std::size_t n);

// Of one to three quantities at once. Above the surface; an interpolation may leave their range.
struct AlbedoFit {
    std::array<glm::dvec3, kAlbedoNodes> coefficients{};  // of the T_n

    glm::dvec3 at(double cos_theta) const;

    // Averaged over cosine-weighted directions.
    glm::dvec3 average() const;
};

AlbedoFit albedo_fit(const std::array<glm::dvec3, kAlbedoNodes>& values);

}  // namespace lacquer::reference
