// The uniform surfaces of a blend, and FLIP's maps of pictures, against what they must be.
#include "study/heightfields/blended_material.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "simulator/facet_material.h"
#include "study/heightfields/blend_pictures.h"

namespace lacquer::study {
namespace {

using ::testing::HasSubstr;

ConductorBase blended_metal(const Blend& blend) {
    return {{1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}, blend};
}

TEST(BlendedMaterial, EqualStrataAreOnePart) {
    const Material material = bare(
        "", blended_metal(asymmetric({stratum(0.25, 0.1), stratum(0.5, 0.6), stratum(0.25, 0.1)})));
    const auto parts = uniform_parts(material);
    ASSERT_EQ(parts.size(), 2u);
    for (const UniformPart& part : parts) EXPECT_EQ(part.weight, 0.5);
    EXPECT_EQ(parts[0].material,
              bare("", ConductorBase{
                           {1.0, 1.0, 1.0}, {2.0, 2.0, 2.0}, Microsurface{Ndf::ggx, {0.1, 0.1}}}));
}

TEST(BlendedMaterial, PartsHaveTheMaterialOfTheirStratum) {
    Stratum red = stratum(0.4, 0.3), plain = stratum(0.6, 0.3);
    red.albedo = Rgb{0.9, 0.1, 0.1};
    const Rgb grey{0.5, 0.5, 0.5};
    const auto parts = uniform_parts(bare("", DiffuseFacetsBase{grey, asymmetric({red, plain})}));
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(std::get<DiffuseFacetsBase>(parts[0].material.base).albedo, *red.albedo);
    EXPECT_EQ(std::get<DiffuseFacetsBase>(parts[1].material.base).albedo, grey);
    EXPECT_EQ(parts[0].weight, 0.4);
}

TEST(BlendedMaterial, ACoatKeepsItsBase) {
    Material coated = bare("", LambertianBase{{0.2, 0.4, 0.6}});
    coated.layers.push_back(
        {{1.5, asymmetric({stratum(0.5, 0.02), stratum(0.5, 0.8)})}, AbsorbingMedium{}});
    for (const UniformPart& part : uniform_parts(coated)) {
        EXPECT_EQ(part.material.base, coated.base);
        EXPECT_TRUE(
            std::holds_alternative<Microsurface>(part.material.layers.front().interface.roughness));
    }
}

TEST(BlendedMaterial, AMetalHasTheColorItIsGiven) {
    constexpr double kRounding = 1e-12;
    const Rgb color{0.05, 0.5, 0.9};
    Stratum stratum_of_metal = stratum(1.0, 0.1);
    set_metal(stratum_of_metal, color);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(simulator::conductor_reflectance(1.0, (*stratum_of_metal.eta)[c],
                                                     (*stratum_of_metal.kappa)[c]),
                    color[c], kRounding);
}

// Radiance that depends on the material's roughness alone: the linear blend is known.
Scene flat_scene() {
    Scene scene{{"flat", "flat", sphere_grid("flat", {0.0, 0.0, 1.0}, 8), 0.0, false}, {}, {}};
    const std::size_t count = scene.view.grid.query_count();
    scene.simulate = [count](const Material& material, std::string_view) {
        const auto& roughness = std::get<DiffuseFacetsBase>(material.base).roughness;
        const auto* uniform = std::get_if<Microsurface>(&roughness);
        const glm::dvec3 light{uniform == nullptr ? 0.25 : uniform->alpha[0]};
        return Radiance{std::vector<glm::dvec3>(count, light),
                        std::vector<glm::dvec3>(count, glm::dvec3{0.0})};
    };
    return scene;
}

TEST(BlendPictures, TheLinearBlendMixesByWeight) {
    constexpr double kFloat = 1e-7;
    Figure figure;
    const std::array materials{bare(
        "diffuse",
        DiffuseFacetsBase{{0.5, 0.5, 0.5}, asymmetric({stratum(0.75, 0.2), stratum(0.25, 0.4)})})};
    add_blends(figure, "flat", materials, flat_scene(), {});
    ASSERT_EQ(figure.errors.size(), 1u);
    EXPECT_EQ(figure.errors[0].model, kLinearBlend);
    EXPECT_NEAR(figure.errors[0].mean, 0.0, kFloat);  // 0.75 0.2 + 0.25 0.4 = 0.25
    const auto& table = std::get<PictureTable>(figure.panels[0]);
    ASSERT_EQ(table.rows.size(), 2u);
    ASSERT_EQ(table.rows[0].pictures.size(), 2 + blend_models().size());
    EXPECT_THAT(table.rows[0].pictures[2].note, HasSubstr("/base"));  // why no model shades it
    const auto& means = std::get<NumberTable>(figure.panels[1]);
    std::vector<std::string> expected{"diffuse", "0.0000", "0.0000"};  // error and FLIP's mean
    expected.insert(expected.end(), blend_models().size(), "-");
    EXPECT_EQ(means.rows[0], expected);
}

TEST(BlendPictures, FlipSeesADifference) {
    Figure figure;
    const std::array materials{bare(
        "diffuse",
        DiffuseFacetsBase{{0.5, 0.5, 0.5}, asymmetric({stratum(0.5, 0.6), stratum(0.5, 0.8)})})};
    add_blends(figure, "flat", materials, flat_scene(), {});
    const double kOff = 0.7 / 0.25 - 1.0;
    EXPECT_NEAR(figure.errors[0].mean, kOff, 1e-12);
    const Picture& map = std::get<PictureTable>(figure.panels[0]).rows[1].pictures[1];
    EXPECT_TRUE(map.to_the_eye);
    EXPECT_EQ(map.limit, kFlipLimit);
    EXPECT_GT(std::stod(std::get<NumberTable>(figure.panels[1]).rows[0][2]), 0.1);
}

}  // namespace
}  // namespace lacquer::study
