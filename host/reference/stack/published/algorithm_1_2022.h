// The light of a Lambertian base through a stack, by the published algorithm: one GGX lobe about
// the normal, carried up through the interfaces with its energy and variance. `stack` has the
// exact form of diffuse_base.h instead; this is measured beside it.
// Based on: de Dinechin and Belcour 2022, Rendering Layered Materials with Diffuse Interfaces,
//           algorithm 1 and Eqs. 9 to 13; Belcour 2018, Efficient Rendering of Layered Materials
//           using an Atomic Decomposition with Statistical Operators, Eqs. 30 to 35
//
// Differs, where the print cannot be meant or leaves a choice: the clamp by sigma_2+ is a min, as
// the text has it, and goes through the roughness of that variance, since what is added is the
// space of 2018, Eq. 6; the scaling of a variance narrows a lobe that enters a denser medium;
// the TIR term is taken relative to the transmittance along the mean, which it would else count
// twice; a medium that absorbs belongs to the interface above it.
#pragma once

#include <glm/vec3.hpp>

#include "reference/normal_lobe.h"
#include "reference/stack/layers.h"

namespace lacquer::reference::published_2022 {

// What the lobe going up is reflected back by, once it has been reflected down: r_{i+1} of Eqs. 12
// and 13.
enum class Below {
    next_interface,  // as printed
    all,             // everything there is, the base too: what adding would have
};

struct DiffuseLobe {
    glm::dvec3 energy;  // of the light that came
    NormalLobe shape;
};

// Of light at `cosine` in (0, 1], over a base of `albedo` in [0, 1]; of one coat the model
// `coated-ggx`. Throws Error for media that scatter, of which the paper says nothing.
DiffuseLobe diffuse_lobe(const StackLayers& layers, const glm::dvec3& albedo, double cosine,
                         Below below);

// f of the base's light, per steradian: 0 unless wi is above the surface. Not reciprocal.
glm::dvec3 eval(const DiffuseLobe& lobe, const glm::dvec3& wi);

}  // namespace lacquer::reference::published_2022
