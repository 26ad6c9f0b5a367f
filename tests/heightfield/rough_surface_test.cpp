// Which materials a heightfield stands for, and what is said of the others.
#include "heightfield/rough_surface.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace lacquer::heightfield {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Material material_of(const std::string& rest) {
    return parse_material(R"({"name": "test", )" + rest + "}", "test.json");
}

Material conductor(const std::string& roughness) {
    return material_of(
        R"("base": {"conductor": {"eta": [0.2, 0.9, 1.1], "kappa": [3.9, 2.5, 2.1], )" + roughness +
        "}}");
}

TEST(RoughSurface, BlendsKeepTheirStrata) {
    const RoughSurface surface = rough_surface(conductor(
        R"("blend": {"operator": "asymmetric", "strata": [
            {"weight": 0.3, "alpha": 0.9, "ndf": "beckmann"},
            {"alpha": [0.2, 0.2], "ndf": "beckmann", "eta": [1, 2, 3], "kappa": [4, 5, 6]}]})"));
    ASSERT_EQ(surface.strata.size(), 2u);
    EXPECT_EQ(surface.strata[0].weight, 0.3);
    EXPECT_EQ(surface.strata[1].weight, 0.7);
    EXPECT_EQ(surface.strata[0].facets.alpha_x, 0.9);
    const auto metal = [&](std::size_t stratum) {
        return std::get<simulator::ConductorFacet>(surface.strata[stratum].material);
    };
    EXPECT_EQ(metal(0).eta, (Rgb{0.2, 0.9, 1.1}));
    EXPECT_EQ(metal(1).eta, (Rgb{1.0, 2.0, 3.0}));
    EXPECT_EQ(metal(1).kappa, (Rgb{4.0, 5.0, 6.0}));
}

TEST(RoughSurface, BareFacetsAndOneInterfaceServe) {
    EXPECT_NO_THROW(rough_surface(conductor(R"("alpha": 0.3, "ndf": "beckmann")")));
    EXPECT_NO_THROW(rough_surface(conductor(R"("alpha": 0)")));  // flat, whatever its facets
    EXPECT_NO_THROW(rough_surface(material_of(
        R"("base": {"diffuse_facets": {"albedo": [1, 1, 1], "alpha": 0.3, "ndf": "beckmann"}})")));
    EXPECT_NO_THROW(
        rough_surface(material_of(R"("layers": [{"interface": {"ior": 1.5, "alpha": [0.3, 0.6],
            "ndf": "beckmann"}}], "base": "none")")));
}

// Each names the material, the place and what would be right.
void expect_refusal(const Material& material, const std::string& place, const std::string& right) {
    EXPECT_THAT([&] { rough_surface(material); },
                ThrowsMessage<Error>(
                    AllOf(HasSubstr("material 'test'"), HasSubstr(place), HasSubstr(right))));
}

TEST(RoughSurface, WhatNoHeightfieldIsIsNamed) {
    expect_refusal(conductor(R"("alpha": 0.3)"), "/base/conductor/ndf", "'beckmann'");
    expect_refusal(conductor(R"("alpha": [0.3, 0], "ndf": "beckmann")"), "/base/conductor/alpha",
                   "both axes");
    expect_refusal(conductor(R"("blend": {"operator": "symmetric", "strata": [
            {"weight": 0.3, "alpha": 0.9, "ndf": "beckmann"}, {"alpha": 0.2, "ndf": "beckmann"}]})"),
                   "/base/conductor/blend/operator", "'asymmetric'");
    expect_refusal(conductor(R"("blend": {"operator": "asymmetric", "strata": [
            {"weight": 0.3, "alpha": 0.9, "ndf": "beckmann"}, {"alpha": [0.2, 0.3], "ndf": "beckmann"}]})"),
                   "/base/conductor/blend/strata/1/alpha", "[0.9, 0.9]");
    expect_refusal(material_of(R"("base": {"lambertian": {"albedo": [1, 1, 1]}})"), "base",
                   "'diffuse_facets'");
    expect_refusal(material_of(R"("layers": [{"interface": {"ior": 1.5, "alpha": 0.3}}],
                                  "base": {"lambertian": {"albedo": [1, 1, 1]}})"),
                   "layer", "'none'");
}

}  // namespace
}  // namespace lacquer::heightfield
