// The light that comes back through a stack from a Lambertian base, exact but for the transport of
// the stack: since the base forgets directions and all above it is reciprocal,
//
//   f(wi, wo) = T(wi) T(wo) rho / (pi n^2 (1 - rho R_bar))
//
// with T(w) the light arriving along w that reaches the base for the first time, R_bar the light
// leaving the base diffusely that returns to it, and n the index above the base over the
// exterior's.
//
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           Eq. 3
#pragma once

#include <glm/vec3.hpp>

#include "reference/stack/fitted_light.h"

namespace lacquer::reference {

// T as a function of direction: what the top interface lets in, of which a cubic of the cosine
// arrives at the base.
struct ArrivingLight {
    StackInterface top;
    Cubic<Energy> share;  // of what has entered

    // At `cosine` in [0, 1].
    Energy at(double cosine) const;

    // Over the hemisphere, weighted by the cosine.
    Energy average() const;
};

struct DiffuseBase {
    ArrivingLight arriving;
    glm::dvec3 spread;    // rho / (pi n^2 (1 - rho R_bar))
    glm::dvec3 returned;  // of the light that has arrived, what leaves the stack
};

// `albedo` of the base in [0, 1].
DiffuseBase prepare_diffuse_base(const StackLayers& layers, const EnteredLight& entered,
                                 const glm::dvec3& albedo);

}  // namespace lacquer::reference
