#include "viewer/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>
#include <vector>

#include "backends/pack.h"
#include "core/model_scope.h"

namespace lacquer::viewer {

namespace {

// A white Lambertian surface that faces the light has radiance 1.
constexpr float kIrradiance = std::numbers::pi_v<float>;

constexpr glm::vec4 kBackground{0.06f, 0.063f, 0.07f, 1.0f};

// Highlights nearer the edge than this would mean a light straight behind the sphere.
constexpr float kMaxHighlightRadius = 0.98f;

// Lights from behind that trace the outline; `color` is their share of the main light.
struct RimLight {
    glm::vec3 direction;
    glm::vec3 color;
};
constexpr std::array kRimLights{RimLight{{0.8f, -0.2f, -0.62f}, {0.2f, 0.27f, 0.38f}},
                                RimLight{{-0.25f, -0.75f, -0.7f}, {0.24f, 0.17f, 0.13f}}};
static_assert(kRimLights.size() + 1 <= kMaxLights);

float radius_in_pixels(std::uint32_t width, std::uint32_t height) {
    return 0.5f * kRadius * static_cast<float>(std::min(width, height));
}

void add_light(SphereView& view, const glm::vec3& direction, const glm::vec3& irradiance) {
    view.light_directions[view.light_count] = glm::vec4{glm::normalize(direction), 0.0f};
    view.light_irradiances[view.light_count] = glm::vec4{irradiance, 0.0f};
    ++view.light_count;
}

}  // namespace

glm::vec3 default_light() {
    return glm::normalize(glm::vec3{-0.5f, 0.65f, 0.6f});
}

std::array<glm::vec4, kSurfaceRows> surface_of(const Material& material, Model model) {
    const std::vector<glm::vec4> rows = pack_surfaces(model, std::span{&material, 1});
    std::array<glm::vec4, kSurfaceRows> surface{};
    std::ranges::copy(std::span{rows}.first(std::min(rows.size(), kSurfaceRows)), surface.begin());
    return surface;
}

Model model_for(const Material& material, Model wanted) {
    const std::vector<Model> models = models_for(material);
    for (const Model model : {wanted, Model::stack, Model::microsurface_compensated})
        if (std::ranges::find(models, model) != models.end()) return model;
    if (models.empty()) require_shadeable(material, wanted);
    return models.front();
}

Model next_model(const Material& material, Model model) {
    const std::span<const Model> models = all_models();
    auto next = std::ranges::find(models, model);
    do {
        if (++next == models.end()) next = models.begin();
    } while (*next != model && why_not_shadeable(material, *next));
    return *next;
}

SphereView sphere_view(const Scene& scene, std::uint32_t width, std::uint32_t height) {
    SphereView view;
    view.surface = scene.surface;
    add_light(view, scene.light, glm::vec3{kIrradiance});
    if (scene.rim_lights)
        for (const RimLight& light : kRimLights)
            add_light(view, light.direction, kIrradiance * light.color);
    const float radius = radius_in_pixels(width, height);
    view.half_extent = 0.5f * glm::vec2{width, height} / radius;
    view.pixel = 1.0f / radius;
    view.background = kBackground;
    return view;
}

glm::vec3 light_with_highlight_at(glm::vec2 pixel, std::uint32_t width, std::uint32_t height) {
    const glm::vec2 from_centre = (pixel - 0.5f * glm::vec2{width, height}) /
                                  radius_in_pixels(width, height) * glm::vec2{1.0f, -1.0f};
    const float shrink = std::min(1.0f, kMaxHighlightRadius / glm::length(from_centre));
    const glm::vec2 position = from_centre * shrink;
    const glm::vec3 normal{position, std::sqrt(1.0f - glm::dot(position, position))};
    return glm::normalize(2.0f * normal.z * normal - glm::vec3{0.0f, 0.0f, 1.0f});
}

}  // namespace lacquer::viewer
