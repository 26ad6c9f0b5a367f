// What the viewer tells its shaders.
#include "viewer/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <vector>

#include "core/error.h"
#include "core/model_scope.h"

namespace lacquer::viewer {
namespace {

constexpr std::uint32_t kWidth = 640;
constexpr std::uint32_t kHeight = 400;
constexpr float kSphereRadius = 0.5f * kRadius * kHeight;  // pixels

// A few roundings of numbers near 1.
constexpr float kTolerance = 1e-5f;

glm::vec2 centre() {
    return {0.5f * kWidth, 0.5f * kHeight};
}

TEST(LightWithHighlightAt, mirrors_the_viewer_at_the_point_under_the_pixel) {
    for (const glm::vec2 position : {glm::vec2{0.0f, 0.0f}, {0.5f, 0.2f}, {-0.3f, -0.9f}}) {
        const glm::vec2 pixel = centre() + kSphereRadius * position * glm::vec2{1.0f, -1.0f};
        const glm::vec3 light = light_with_highlight_at(pixel, kWidth, kHeight);
        const glm::vec3 halfway = glm::normalize(light + glm::vec3{0.0f, 0.0f, 1.0f});
        EXPECT_NEAR(halfway.x, position.x, kTolerance);
        EXPECT_NEAR(halfway.y, position.y, kTolerance);
        EXPECT_NEAR(glm::length(light), 1.0f, kTolerance);
    }
}

TEST(LightWithHighlightAt, is_at_the_edge_towards_a_pixel_outside_the_sphere) {
    const glm::vec3 light = light_with_highlight_at({kWidth, 0.5f * kHeight}, kWidth, kHeight);
    EXPECT_NEAR(light.y, 0.0f, kTolerance);
    EXPECT_GT(light.x, 0.0f);
    EXPECT_LT(light.z, -0.9f);  // nearly behind the sphere
}

TEST(SphereView, measures_the_picture_in_radii_of_the_sphere) {
    const SphereView view = sphere_view({.light = default_light()}, kWidth, kHeight);
    EXPECT_FLOAT_EQ(view.half_extent.y, 1.0f / kRadius);
    EXPECT_FLOAT_EQ(view.half_extent.x / view.half_extent.y, 1.0f * kWidth / kHeight);
    EXPECT_FLOAT_EQ(view.pixel * kSphereRadius, 1.0f);
}

TEST(SphereView, has_unit_light_directions) {
    const SphereView view = sphere_view({.light = default_light()}, kWidth, kHeight);
    ASSERT_EQ(view.light_count, 3u);
    for (std::uint32_t light = 0; light < view.light_count; ++light)
        EXPECT_NEAR(glm::length(glm::vec3{view.light_directions[light]}), 1.0f, kTolerance);
}

TEST(Models, follow_each_other_as_far_as_they_can_shade_the_material) {
    const Material coated{"coated", 1.0, {Layer{}}, LambertianBase{}, {}};
    const Material metal{"metal", 1.0, {}, ConductorBase{{1, 1, 1}, {1, 1, 1}, {}}, {}};
    for (const Material* material : {&coated, &metal}) {
        const std::vector<Model> able = models_for(*material);
        std::vector<Model> seen;
        for (Model model = Model::plain; seen.size() < able.size(); seen.push_back(model))
            model = next_model(*material, model);
        EXPECT_EQ(seen.back(), Model::plain);  // round once
        EXPECT_EQ(std::set<Model>(seen.begin(), seen.end()),
                  std::set<Model>(able.begin(), able.end()));
    }
    for (const Model model : all_models()) {
        const auto shades = [&](const Material& material) {
            return !why_not_shadeable(material, model);
        };
        EXPECT_EQ(model_for(metal, model), shades(metal) ? model : Model::microsurface_compensated);
        EXPECT_EQ(model_for(coated, model), shades(coated) ? model : Model::stack);
    }
}

TEST(Models, that_shade_blends_are_found_for_them) {
    const Blend worn{
        Blend::Operator::asymmetric,
        {{0.5, {Ndf::ggx, {0.1, 0.1}}, {}, {}, {}}, {0.5, {Ndf::ggx, {0.5, 0.5}}, {}, {}, {}}}};
    const Material metal{"metal", 1.0, {}, ConductorBase{{1, 1, 1}, {1, 1, 1}, worn}, {}};
    EXPECT_EQ(model_for(metal, Model::coated_exact), Model::microsurface_compensated);
    const Material facets{"facets", 1.0, {}, DiffuseFacetsBase{{1, 1, 1}, worn}, {}};
    EXPECT_THROW(model_for(facets, Model::plain), Error);
}

TEST(Models, that_shade_one_layer_leave_more_to_the_stack) {
    const Material coated_twice{"coated twice", 1.0, {Layer{}, Layer{}}, LambertianBase{}, {}};
    EXPECT_EQ(model_for(coated_twice, Model::coated_exact), Model::stack);
    EXPECT_EQ(model_for(coated_twice, Model::plain), Model::plain);
}

TEST(SphereView, has_one_light_without_the_rim_lights) {
    EXPECT_EQ(
        sphere_view({.light = default_light(), .rim_lights = false}, kWidth, kHeight).light_count,
        1u);
}

}  // namespace
}  // namespace lacquer::viewer
