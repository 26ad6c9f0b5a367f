// load_material and parse_material: what they accept, and what they say about what they do not.
#include "lacquer/material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "cases.h"
#include "core/error.h"
#include "core/paths.h"
#include "material/optical_constants.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using testing::HasSubstr;

// The message of the Error that `action` throws; empty where it throws none.
template <typename Action>
std::string error_of(const Action& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::string parse_error(const std::string& text) {
    return error_of([&] { parse_material(text, test::kOrigin); });
}

class RightFile : public testing::TestWithParam<test::MaterialCase> {};

TEST_P(RightFile, IsRead) {
    EXPECT_EQ(parse_error(GetParam().text), "");
}

class WrongFile : public testing::TestWithParam<test::MaterialCase> {};

TEST_P(WrongFile, SaysWhereAndWhat) {
    const std::string message = parse_error(GetParam().text);
    EXPECT_THAT(message, testing::StartsWith(test::kOrigin + ":"));
    for (const std::string& part : GetParam().message_parts) EXPECT_THAT(message, HasSubstr(part));
}

const auto kCaseName = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Material, RightFile, testing::ValuesIn(test::right_cases()), kCaseName);
INSTANTIATE_TEST_SUITE_P(Values, WrongFile, testing::ValuesIn(test::wrong_values()), kCaseName);
INSTANTIATE_TEST_SUITE_P(Blends, WrongFile, testing::ValuesIn(test::wrong_blends()), kCaseName);
INSTANTIATE_TEST_SUITE_P(Shapes, WrongFile, testing::ValuesIn(test::wrong_shapes()), kCaseName);
INSTANTIATE_TEST_SUITE_P(Texts, WrongFile, testing::ValuesIn(test::wrong_texts()), kCaseName);

Material right(const std::string& name) {
    for (const test::MaterialCase& entry : test::right_cases())
        if (entry.name == name) return parse_material(entry.text, test::kOrigin);
    throw std::out_of_range{name};
}

TEST(Material, HoldsWhatTheFileSays) {
    const Material material = right("celadon");
    ASSERT_EQ(material.layers.size(), 1u);
    EXPECT_EQ(material.layers[0].interface, (Interface{1.5, Microsurface{Ndf::ggx, {0.12, 0.12}}}));
    EXPECT_EQ(std::get<AbsorbingMedium>(material.layers[0].medium).tau, (Rgb{0.7, 0.9, 0.8}));
    EXPECT_EQ(std::get<LambertianBase>(material.base).albedo, (Rgb{0.8, 0.8, 0.75}));
    EXPECT_TRUE(material.textures.empty());
}

TEST(Material, HasDefaults) {
    const Material material = right("lambertian_alone");
    EXPECT_EQ(material.name, "case");  // the file's
    EXPECT_EQ(material.exterior_ior, 1.0);
    EXPECT_TRUE(material.layers.empty());
    // A layer without a medium is clear.
    EXPECT_EQ(std::get<AbsorbingMedium>(right("glass").layers[0].medium).tau, (Rgb{1, 1, 1}));
}

TEST(Material, ReadsScatteringMediaAndAnisotropy) {
    const Layer layer = right("scattering").layers[0];
    EXPECT_EQ(layer.medium, (Medium{ScatteringMedium{{0, 1, 2}, {1, 1, 1e9}, -0.99, 0}}));
    EXPECT_EQ(layer.interface.roughness, (Roughness{Microsurface{Ndf::ggx, {0.1, 0.4}}}));
}

TEST(Material, ResolvesMetalsFromTheTable) {
    const OpticalConstants* gold = find_optical_constants("gold");
    ASSERT_NE(gold, nullptr);
    const Material material = right("metal");
    const auto& conductor = std::get<ConductorBase>(material.base);
    EXPECT_EQ(conductor.eta, gold->eta);
    EXPECT_EQ(conductor.kappa, gold->kappa);
    EXPECT_EQ(conductor.roughness, (Roughness{Microsurface{Ndf::beckmann, {1, 1}}}));
}

// Johnson and Christy 1974: titanium at 0.617 and 0.659 um is 2.67 + 3.72 i and 2.76 + 3.84 i,
// which interpolates to the table's red, taken at 0.650 um.
TEST(OpticalConstants, TitaniumIsJohnsonAndChristys) {
    const OpticalConstants* titanium = find_optical_constants("titanium");
    ASSERT_NE(titanium, nullptr);
    const double share = (0.650 - 0.617) / (0.659 - 0.617);
    constexpr double kTableStep = 0.001;
    EXPECT_NEAR(titanium->eta[0], 2.67 + share * (2.76 - 2.67), kTableStep / 2);
    EXPECT_NEAR(titanium->kappa[0], 3.72 + share * (3.84 - 3.72), kTableStep / 2);
}

TEST(Material, GivesTheLastStratumTheRest) {
    const Material material = right("blended_interface");
    const auto& blend = std::get<Blend>(material.layers[0].interface.roughness);
    EXPECT_EQ(blend.op, Blend::Operator::asymmetric);
    ASSERT_EQ(blend.strata.size(), 3u);
    EXPECT_EQ(blend.strata[0], (Stratum{0.5, {Ndf::beckmann, {0.02, 0.02}}, {}, {}, {}}));
    EXPECT_EQ(blend.strata[1], (Stratum{0.25, {Ndf::ggx, {0.1, 0.2}}, {}, {}, {}}));
    EXPECT_EQ(blend.strata[2], (Stratum{0.25, {Ndf::beckmann, {0.8, 0.8}}, {}, {}, {}}));
}

TEST(Material, LetsStrataHaveTheirOwnMaterial) {
    const Material metals = right("blended_metals");
    const auto& strata = std::get<Blend>(std::get<ConductorBase>(metals.base).roughness).strata;
    EXPECT_EQ(strata[0].eta, find_optical_constants("gold")->eta);
    EXPECT_EQ(strata[1].kappa, (Rgb{2, 2, 2}));
    const Material facets = right("blended_facets");
    const auto& diffuse = std::get<DiffuseFacetsBase>(facets.base);
    EXPECT_EQ(std::get<Blend>(diffuse.roughness).strata[0].albedo, (Rgb{0, 0, 0}));
    EXPECT_FALSE(std::get<Blend>(diffuse.roughness).strata[1].albedo.has_value());
    EXPECT_EQ(diffuse.albedo, (Rgb{1, 1, 1}));
}

TEST(Material, RecordsTextures) {
    const std::vector<TextureReference> expected{
        {"/exterior_ior", "folder/ior.exr", 'a'},
        {"/layers/0/interface/alpha/0", "folder/rough.exr", 'r'},
        {"/base/lambertian/albedo/0", "folder/wood.png", 'r'},
        {"/base/lambertian/albedo/1", "folder/wood.png", 'g'},
        {"/base/lambertian/albedo/2", "folder/wood.png", 'b'},
    };
    EXPECT_EQ(right("textures").textures, expected);
}

TEST(LoadMaterial, NamesWhatCannotBeRead) {
    const test::TemporaryFolder folder;
    const auto load_error = [](const std::filesystem::path& file) {
        return error_of([&] { load_material(file); });
    };
    EXPECT_THAT(load_error(folder / "none.json"),
                testing::AllOf(HasSubstr("none.json"), HasSubstr("No such file")));
    EXPECT_THAT(load_error(folder.path()), HasSubstr("is a folder, expected a material file"));
    std::ofstream{folder / "empty.json"};
    EXPECT_THAT(load_error(folder / "empty.json"), HasSubstr("empty.json:1:1: not valid JSON"));
    std::ofstream{folder / "large.json"} << std::string(300'000, ' ');
    EXPECT_THAT(load_error(folder / "large.json"), HasSubstr("larger than 262144 bytes"));
    EXPECT_THAT(load_error("/dev/zero"), HasSubstr("larger than"));
}

TEST(LoadMaterial, ReadsEveryBundledMaterial) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator{share_file("materials")}) {
        const Material material = load_material(entry.path());
        EXPECT_NE(material.name, entry.path().stem().string()) << "the file has no name of its own";
        ++count;
    }
    EXPECT_GE(count, 8);
}

}  // namespace
}  // namespace lacquer
