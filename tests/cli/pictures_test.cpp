#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "cli/run_lacquer.h"
#include "core/file.h"
#include "image/display.h"
#include "image/image_file.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using test::expect_success;
using test::kLambertian;
using test::run_lacquer;
using test::TemporaryFolder;
using test::Words;
using ::testing::Contains;
using ::testing::Pair;

constexpr float kPi = std::numbers::pi_v<float>;

// Directions are rounded to float before they are shaded.
constexpr float kRounding = 1e-6f;

class Pictures : public ::testing::Test {
 protected:
    Pictures() { write_file(folder_ / "matte.json", kLambertian); }

    // Runs the command on `material`, writing to `output`, and reads what it wrote.
    ExrPicture draw(Words words, const std::string& material, const std::string& output) {
        const Words files{"--material", (folder_ / material).string(), "-o",
                          (folder_ / output).string()};
        words.insert(words.end(), files.begin(), files.end());
        expect_success(run_lacquer(words));
        return decode_exr(read_file(folder_ / output), output);
    }

    TemporaryFolder folder_;
};

TEST_F(Pictures, ASliceOfALambertianBaseIsItsAlbedoOverPi) {
    const Image image = draw({"slice", "--size", "32"}, "matte.json", "x.exr").image;
    ASSERT_EQ(image.width, 32);
    EXPECT_NEAR(image.at(16, 16).y, 0.25f / kPi, kRounding);
    EXPECT_EQ(image.at(16, 16).w, 1.0f);
    EXPECT_EQ(image.at(0, 0), glm::vec4(0.0f));
}

TEST_F(Pictures, SayHowTheyWereMade) {
    const Metadata metadata =
        draw({"slice", "--size", "8", "--backend", "cpp"}, "matte.json", "x.exr").metadata;
    EXPECT_THAT(metadata, Contains(Pair("material", "matte")));
    EXPECT_THAT(metadata, Contains(Pair("model", "plain")));
    EXPECT_THAT(metadata, Contains(Pair("backend", "cpp")));
    EXPECT_THAT(metadata, Contains(Pair("version", ::testing::Not(""))));
}

TEST_F(Pictures, ASphereFacingTheLightHasRadianceAlbedoTimesCosine) {
    const Image image =
        draw({"sphere", "--size", "65", "--light", "0,0,1"}, "matte.json", "x.exr").image;
    EXPECT_NEAR(image.at(32, 32).x, 0.5f, kRounding);
    // The pixel halfway to the edge: its normal's z is the cosine.
    const float x = (2.0f * 48 + 1) / 65 - 1;
    EXPECT_NEAR(image.at(48, 32).z, std::sqrt(1 - x * x), kRounding);
    EXPECT_EQ(image.at(0, 0).w, 0.0f);
}

TEST_F(Pictures, ASphereLitFromBehindIsBlack) {
    const Image image =
        draw({"sphere", "--size", "16", "--light", "0,0,-1"}, "matte.json", "x.exr").image;
    EXPECT_EQ(image.at(8, 8), glm::vec4(0, 0, 0, 1));
}

TEST_F(Pictures, APngShowsTheExrThroughTheToneCurve) {
    const Words sphere{"sphere", "--size", "32"};
    const Image linear = draw(sphere, "matte.json", "x.exr").image;
    Words words = sphere;
    for (const std::string& word : {std::string{"--material"}, (folder_ / "matte.json").string(),
                                    std::string{"-o"}, (folder_ / "x.png").string()})
        words.push_back(word);
    expect_success(run_lacquer(words));
    const Image shown = read_image(folder_ / "x.png");
    for (std::size_t i = 0; i < linear.pixels.size(); ++i) {
        const DisplayColor expected = display_color(linear.pixels[i]);
        ASSERT_EQ(shown.pixels[i] * 255.0f,
                  glm::vec4(expected.r, expected.g, expected.b, expected.a));
    }
}

TEST_F(Pictures, ATextureOfOneValueIsThatValue) {
    Image image{4, 2};
    for (glm::vec4& pixel : image.pixels) pixel = {0.5f, 0.25f, 1.0f, 1.0f};
    write_image(folder_ / "albedo.exr", image, {});
    write_file(folder_ / "textured.json", R"({"name": "matte", "base": {"lambertian": {"albedo": [
        {"texture": "albedo.exr", "channel": "r"}, {"texture": "albedo.exr", "channel": "g"},
        {"texture": "albedo.exr", "channel": "b"}]}}})");
    for (const char* backend : {"reference", "cpp"}) {
        const Words sphere{"sphere", "--size", "48", "--backend", backend};
        EXPECT_EQ(draw(sphere, "textured.json", "a.exr").image.pixels,
                  draw(sphere, "matte.json", "b.exr").image.pixels);
    }
}

TEST_F(Pictures, ATextureRunsAroundTheSphere) {
    // Left half of the picture dark, right half bright; longitude grows to the right.
    Image image{64, 1};
    for (int x = 0; x < 64; ++x) image.at(x, 0).x = x < 32 ? 0.25f : 0.75f;
    write_image(folder_ / "halves.exr", image, {});
    write_file(folder_ / "textured.json", R"({"name": "halves", "base": {"lambertian": {"albedo": [
        {"texture": "halves.exr"}, 0.5, 0.5]}}})");
    const Image sphere =
        draw({"sphere", "--size", "64", "--light", "0,0,1"}, "textured.json", "x.exr").image;
    const auto albedo = [&](int x) { return 0.5f * sphere.at(x, 32).x / sphere.at(x, 32).y; };
    EXPECT_NEAR(albedo(16), 0.25f, kRounding);
    EXPECT_NEAR(albedo(48), 0.75f, kRounding);
}

TEST_F(Pictures, APngOfAnAlbedoIsDecoded) {
    Image image{1, 1};
    image.at(0, 0) = {0.5f, 0.5f, 0.5f, 1.0f};
    write_image(folder_ / "grey.png", image, {});
    const float level = read_image(folder_ / "grey.png").at(0, 0).x;
    write_file(folder_ / "textured.json", R"({"name": "grey", "base": {"lambertian": {"albedo": [
        {"texture": "grey.png"}, 0.5, 0.5]}}})");
    const Image sphere =
        draw({"sphere", "--size", "33", "--light", "0,0,1"}, "textured.json", "x.exr").image;
    EXPECT_NEAR(sphere.at(16, 16).x, srgb_decode(level), kRounding);
}

}  // namespace
}  // namespace lacquer
