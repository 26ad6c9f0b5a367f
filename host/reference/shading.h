// What the models have in common: what their functions return, and the terms on which they choose
// among lobes. Directions are local (z = normal), unit, and point away from the surface: wi to the
// light, wo to the viewer.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "lacquer/material.h"

namespace lacquer::reference {

// Roughnesses below this are shaded at this: a narrower lobe has no width a renderer could sample.
inline constexpr double kMinAlpha = 1e-3;

// A lobe is chosen at least this often by `sample`, so that no weight grows beyond ten times its
// own.
inline constexpr double kMinChoice = 0.1;

struct Sample {
    glm::dvec3 wi{0.0, 0.0, 1.0};
    glm::dvec3 weight{0.0};  // f |cos_theta_i| / pdf; 0 where no lobe sends light to wi
    double pdf = 0.0;        // per solid angle; 0 where no lobe sends light to wi
};

// Directional albedo, split by where the light turned back.
struct Albedo {
    glm::dvec3 direct{0.0};  // never reached the base
    glm::dvec3 base{0.0};
    glm::dvec3 transmitted{0.0};  // left below; no part of what is reflected
};

bool is_above(const glm::dvec3& w);

glm::dvec3 vector_of(const Rgb& rgb);

double mean(const glm::dvec3& rgb);

// A direction of density cos_theta / pi, from u in [0, 1)^2.
glm::dvec3 sample_cosine(const glm::dvec2& u);

}  // namespace lacquer::reference
