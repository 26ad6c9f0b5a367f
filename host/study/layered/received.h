// What viewers receive from isotropic materials in surroundings: simulated, and by models.
#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "simulator/stack.h"
#include "study/layered/studio.h"
#include "study/model_light.h"
#include "study/view.h"

namespace lacquer::study {

// Where a surface stands in its surroundings: world directions of its local axes.
struct Frame {
    glm::dvec3 x{1.0, 0.0, 0.0}, y{0.0, 1.0, 0.0}, z{0.0, 0.0, 1.0};
};

// The frame of a surface of normal `normal` in which a viewer at the world direction `viewer` is in
// the plane y = 0, at positive x.
Frame frame_towards(const glm::dvec3& normal, const glm::dvec3& viewer);

// The local direction of that viewer.
glm::dvec3 local_viewer(const glm::dvec3& normal, const glm::dvec3& viewer);

// Light that leaves a material in one direction of many.
struct Outgoing {
    glm::dvec3 direction{0.0, 0.0, 1.0};
    glm::dvec3 weight{0.0};
};

// The radiance that reaches the viewer in each of `frames`: by reciprocity the mean of what `emit`
// sends from the viewer into the surroundings. The material's mirror image in the plane of the
// viewer is itself: each direction serves twice. The standard errors are those of random
// directions.
Radiance received(std::span<const Frame> frames, Surroundings surroundings, std::uint64_t count,
                  const std::function<Outgoing(std::uint64_t n)>& emit);

// The same from two halves of `count` directions that each fill the light evenly; the errors are
// half of what they differ by.
Radiance received_evenly(std::span<const Frame> frames, Surroundings surroundings,
                         std::uint64_t count, const std::function<Outgoing(std::uint64_t n)>& emit);

// The n-th walk of light from the viewer's `wo`, reversed; lost where it meets more facets than
// `max_order`.
Outgoing walked(const simulator::StackWalk& stack, const glm::dvec3& wo, std::uint64_t seed,
                std::uint64_t n, int max_order = simulator::kAllOrders);

// The n-th of the model's own samples, which fill its lobes evenly.
Outgoing sampled(const ModelLight& model, const glm::dvec3& wo, std::uint64_t n);

}  // namespace lacquer::study
