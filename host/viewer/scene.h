// What the window shows, and how it reaches the shaders of the variant `sphere_view`.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "core/model.h"
#include "lacquer/material.h"

namespace lacquer::viewer {

inline constexpr std::size_t kSurfaceRows = 59;  // as many as any model needs
inline constexpr std::size_t kMaxLights = 4;

// LqSphereView of shader_src/viewer/view.glsl, byte for byte (std140).
struct SphereView {
    std::array<glm::vec4, kSurfaceRows> surface{};
    std::array<glm::vec4, kMaxLights> light_directions{};
    std::array<glm::vec4, kMaxLights> light_irradiances{};
    glm::vec4 background{};
    glm::vec2 half_extent{};
    float pixel = 0.0f;
    std::uint32_t light_count = 0;
};
static_assert(sizeof(SphereView) == 1104);

struct Scene {
    Model model = Model::plain;
    std::array<glm::vec4, kSurfaceRows> surface{};
    glm::vec3 light{};  // unit, towards the light
    bool rim_lights = true;
};

// From above the viewer's left shoulder, as in the pictures of `lacquer compare`.
glm::vec3 default_light();

// The packed rows of `material`, the rest 0. Throws Error where `model` cannot shade it.
std::array<glm::vec4, kSurfaceRows> surface_of(const Material& material, Model model);

// `wanted` where it can shade `material`; otherwise `stack`, which leaves nothing out, or `plain`,
// or the first that can. Throws Error where no model can.
Model model_for(const Material& material, Model wanted);

// The model after `model`, of those that can shade `material`.
Model next_model(const Material& material, Model model);

// A picture of `width` x `height` pixels, the sphere's radius kRadius of its shorter half.
SphereView sphere_view(const Scene& scene, std::uint32_t width, std::uint32_t height);

inline constexpr float kRadius = 0.8f;

// The light whose highlight on a smooth sphere is at `pixel` of such a picture, counted from the
// upper left; at the sphere's edge for pixels outside it.
glm::vec3 light_with_highlight_at(glm::vec2 pixel, std::uint32_t width, std::uint32_t height);

}  // namespace lacquer::viewer
