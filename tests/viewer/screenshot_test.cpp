// Screenshots of the viewer against pictures of the C++ reference.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "backends/backend.h"
#include "compare/grids.h"
#include "core/environment.h"
#include "core/paths.h"
#include "core/process.h"
#include "image/display.h"
#include "image/image_file.h"

namespace lacquer {
namespace {

namespace fs = std::filesystem;

// A window whose sphere, of 4/5 its size, is as large as the reference's picture.
constexpr int kSphereSize_px = 256;
constexpr int kWindowSize_px = 320;
constexpr int kMargin_px = (kWindowSize_px - kSphereSize_px) / 2;

// The viewer smooths the sphere's edge over one pixel, the reference does not.
constexpr double kEdge_px = 1.0;

// One level for the rounding of either side, which may fall on different sides of a half.
constexpr int kTolerance_levels = 2;

const glm::dvec3 kLight{-0.48, 0.64, 0.6};

struct Picture {
    const char* material;
    Model model;
};

struct Screenshot : testing::TestWithParam<Picture> {};

ProcessResult view(const std::vector<std::string>& options, const fs::path& screenshot) {
    std::vector<std::string> arguments{"-a",           LACQUER_PROGRAM, "view",
                                       "--validation", "--screenshot",  screenshot.string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_process(LACQUER_XVFB_RUN, arguments);
}

std::vector<DisplayColor> reference_picture(const Picture& picture) {
    const Material material =
        load_material(share_file(fmt::format("materials/{}.json", picture.material)));
    const QueryGrid grid = sphere_grid("sphere", kLight, kSphereSize_px);
    const auto backend = backend_from_name("reference").create({});
    const Job job{.model = picture.model,
                  .kernel = grid.kernel,
                  .materials = std::span{&material, 1},
                  .queries_per_material = grid.query_count(),
                  .inputs = grid.inputs,
                  .parameters = grid.parameters};
    return display_pixels(paint(grid, backend->run(job).rows));
}

bool is_inside_the_edge(int x, int y) {
    const double centre = 0.5 * kSphereSize_px;
    return std::hypot(x + 0.5 - centre, y + 0.5 - centre) < centre - kEdge_px;
}

int levels(float channel) {
    return static_cast<int>(std::lround(255.0f * channel));
}

int difference(const glm::vec4& shown, const DisplayColor& expected) {
    return std::max({std::abs(levels(shown.r) - expected.r), std::abs(levels(shown.g) - expected.g),
                     std::abs(levels(shown.b) - expected.b)});
}

std::string name_of(const Picture& picture) {
    std::string name = fmt::format("{}_{}", picture.material, model_name(picture.model));
    std::ranges::replace(name, '-', '_');
    return name;
}

TEST_P(Screenshot, is_the_reference_s_picture_of_the_material) {
    if (std::string{LACQUER_XVFB_RUN}.empty()) GTEST_SKIP() << "xvfb-run is not installed";
    const Picture picture = GetParam();
    const fs::path file = fs::path{LACQUER_SCREENSHOTS} / (name_of(picture) + ".png");
    const ProcessResult result =
        view({"--material", picture.material, "--model", std::string{model_name(picture.model)},
              "--size", std::to_string(kWindowSize_px), "--light",
              fmt::format("{},{},{}", kLight.x, kLight.y, kLight.z)},
             file);
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Image shown = read_image(file);
    ASSERT_EQ(shown.width, kWindowSize_px);
    ASSERT_EQ(shown.height, kWindowSize_px);
    const std::vector<DisplayColor> expected = reference_picture(picture);
    int largest = 0;
    for (int y = 0; y < kSphereSize_px; ++y)
        for (int x = 0; x < kSphereSize_px; ++x)
            if (is_inside_the_edge(x, y))
                largest = std::max(largest, difference(shown.at(x + kMargin_px, y + kMargin_px),
                                                       expected[y * kSphereSize_px + x]));
    EXPECT_LE(largest, kTolerance_levels);
}

INSTANTIATE_TEST_SUITE_P(
    Materials, Screenshot,
    testing::Values(
        Picture{"gold", Model::plain}, Picture{"aluminium", Model::plain},
        Picture{"porcelain", Model::plain}, Picture{"frosted_glass", Model::plain},
        Picture{"lacquered_copper", Model::plain}, Picture{"red_plastic", Model::openpbr_coat},
        Picture{"celadon", Model::coated_exact}, Picture{"porcelain", Model::coated_ggx},
        Picture{"air_film_underwater", Model::coated_exact},
        Picture{"two_tone_car_paint", Model::stack}, Picture{"frosted_metal", Model::stack},
        Picture{"pearl_over_gold", Model::stack}, Picture{"five_layer_furnace", Model::stack}),
    [](const auto& test) { return name_of(test.param); });

TEST(View, draws_frame_after_frame_without_validation_messages) {
    if (std::string{LACQUER_XVFB_RUN}.empty()) GTEST_SKIP() << "xvfb-run is not installed";
    const fs::path file = fs::path{LACQUER_SCREENSHOTS} / "frames.png";
    const ProcessResult result = view({"--frames", "5", "--size", "128"}, file);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(fs::exists(file));
}

TEST(View, refuses_a_model_that_cannot_shade_the_material) {
    const ProcessResult result =
        run_process(LACQUER_PROGRAM, {"view", "--material", "gold", "--model", "coated-exact"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("the model 'coated-exact' shades one layer"), std::string::npos)
        << result.err;
}

TEST(View, says_that_there_is_no_display) {
    ScopedEnvironment environment;
    environment.unset("DISPLAY");
    environment.unset("WAYLAND_DISPLAY");
    const ProcessResult result = run_process(LACQUER_PROGRAM, {"view", "--frames", "1"});
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("no window can be opened"), std::string::npos) << result.err;
}

TEST(View, refuses_a_light_that_is_no_unit_direction) {
    const ProcessResult result = run_process(LACQUER_PROGRAM, {"view", "--light", "1,1,1"});
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.err.find("--light: (1, 1, 1) has length 1.73205"), std::string::npos)
        << result.err;
}

}  // namespace
}  // namespace lacquer
