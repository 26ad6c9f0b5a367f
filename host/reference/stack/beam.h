// Light that travels one way through one medium of a stack, as lobes that share a mean direction.
#pragma once

#include <glm/vec4.hpp>

namespace lacquer::reference {

// Red, green and blue, and what they would be if no medium absorbed.
using Energy = glm::dvec4;

double sum(const Energy& energy);

// Light of one origin.
struct LobeLight {
    Energy energy{0.0};
    double width = 0.0;  // see lobe_width.h

    // Adds light; the width of all is averaged by energy.
    void add(const LobeLight& more);

    // Facets of roughness `alpha` reflect it. Belcour 2018, Eqs. 8 and 9.
    void reflect(double alpha);
};

// By what the light has met so far: nothing that reflects, interfaces below the top one at most, or
// the base.
struct Beam {
    double cosine = 1.0;  // of the mean direction
    LobeLight through, interfaces, base;

    Energy energy() const;

    // Of all light as one lobe: its roughness.
    double alpha() const;

    // Adds light, whose mean is averaged by energy.
    void add(const Beam& more);

    // Every lobe's energy times a factor.
    void scale(const Energy& factor);

    // Applies `change` to all lobes.
    template <typename Change>
    void for_each_lobe(const Change& change) {
        change(through);
        change(interfaces);
        change(base);
    }
};

}  // namespace lacquer::reference
