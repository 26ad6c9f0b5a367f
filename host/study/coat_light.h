// What a coat over a Lambertian base makes of light, by the simulator alone: for pictures.
//
// The coat's own light is estimated at each pair of directions by next events; a coat over nothing
// sends back just that. The base's light leaves walks of the whole material; it is counted in rings
// around the normal, since neither an isotropic coat nor a Lambertian base prefers an azimuth.
#pragma once

#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "lacquer/material.h"
#include "simulator/rgb_estimate.h"
#include "simulator/stack.h"
#include "study/run.h"
#include "study/view.h"

namespace lacquer::study {

// Rings of equal cos_theta_i.
inline constexpr int kRings = 64;

// For one viewer.
struct BaseLight {
    double cos_theta_o = 1.0;
    std::vector<simulator::RgbEstimate> rings;  // energy per ring, of the light that arrived
    simulator::RgbEstimate base, direct;        // albedos
};

BaseLight simulate_base_light(const simulator::StackWalk& stack, double cos_theta_o, int rings,
                              const simulator::RunOptions& options);

// The pictures of a material of one isotropic coat, rougher than 0, over a Lambertian base: a
// sphere from run.samples walks of the whole material for viewers at 64 angles, a slice from half
// as many.
Radiance simulate(const View& view, const Material& material, const StudyRun& run);

}  // namespace lacquer::study
