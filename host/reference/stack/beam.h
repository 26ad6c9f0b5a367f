// Light that travels one way through one medium of a stack, as lobes that share a mean direction.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <vector>

#include "reference/stack/lobe_shape.h"

namespace lacquer::reference {

// Red, green and blue, and what they would be if no medium absorbed.
using Energy = glm::dvec4;

double sum(const Energy& energy);

// The light whose deepest reflection was at one interface or at the base.
struct LobeLight {
    Energy energy{0.0};
    double variance = 0.0;  // see LobeShape

    // Adds light; the width of all is averaged by energy.
    void add(const Energy& more, double more_variance);
};

struct Beam {
    double sine = 0.0;             // of the mean direction
    bool diffuse = false;          // comes from everywhere alike, whatever its lobes say
    std::vector<LobeLight> lobes;  // from the top interface's to the base's

    explicit Beam(std::size_t lobe_count) : lobes(lobe_count) {}

    Energy energy() const;

    // Of all lobes as one.
    LobeShape shape() const;

    // Adds light, whose mean is averaged by energy.
    void add(const Beam& more);
};

}  // namespace lacquer::reference
