// FLIP where its value follows from the paper's formulas alone.
#include "image/flip.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace lacquer {
namespace {

using testing::DoubleNear;
using testing::Each;

constexpr int kSize = 41;
constexpr DisplayColor kBlack{0, 0, 0}, kWhite{255, 255, 255}, kGreen{0, 255, 0}, kBlue{0, 0, 255};

using Picture = std::vector<DisplayColor>;

template <typename Color>
Picture paint(const Color& color) {
    Picture picture;
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x) picture.push_back(color(x, y));
    return picture;
}

Picture uniform(const DisplayColor& color) {
    return paint([&](int, int) { return color; });
}

DisplayColor grey(int level) {
    const auto byte = static_cast<std::uint8_t>(level);
    return {byte, byte, byte};
}

// CIELAB's lightness of a grey.
double lightness(int level) {
    const double y = srgb_decode(level / 255.0);
    return y > 216.0 / 24389.0 ? 116.0 * std::cbrt(y) - 16.0 : 24389.0 / 27.0 * y;
}

// The largest distance, that of green from blue, before it is compressed: from their textbook
// CIELAB coordinates, (87.735, -86.183, 83.179) and (32.297, 79.188, -107.860), with Hunt's
// adjustment.
const double kLargest = std::pow(
    55.438 + std::hypot(0.87735 * -86.183 - 0.32297 * 79.188, 0.87735 * 83.179 + 0.32297 * 107.86),
    0.7);

// Uniform pictures have no features, and neither has the filter anything to do.
double expected_of_greys(int level, int other) {
    const double bend = 0.4 * kLargest;
    const double distance = std::pow(std::abs(lightness(level) - lightness(other)), 0.7);
    return distance < bend ? 0.95 * distance / bend
                           : 0.95 + 0.05 * (distance - bend) / (kLargest - bend);
}

TEST(Flip, SeesNothingBetweenEqualPictures) {
    const Picture picture = paint([](int x, int y) { return DisplayColor(grey(x * y % 256)); });
    EXPECT_THAT(flip(picture, picture, kSize), Each(0.0));
}

TEST(Flip, OfUniformGreysIsThatOfTheirLightness) {
    constexpr double kDigits = 1e-4;  // of the textbook's coordinates, and of sRGB's matrix
    for (const auto& [level, other] :
         {std::pair{0, 255}, {0, 1}, {0, 60}, {100, 101}, {128, 200}, {250, 30}})
        EXPECT_THAT(flip(uniform(grey(level)), uniform(grey(other)), kSize),
                    Each(DoubleNear(expected_of_greys(level, other), kDigits)))
            << level << ' ' << other;
    // Black and white differ by less than colours can.
    EXPECT_NEAR(expected_of_greys(0, 255), 0.967, 0.001);
}

TEST(Flip, IsOneBetweenGreenAndBlue) {
    EXPECT_THAT(flip(uniform(kGreen), uniform(kBlue), kSize), Each(DoubleNear(1.0, 1e-12)));
}

// A step between black and white is an edge of contrast 1 beside it, and no point: that raises a
// colour's error e to e^(1 - sqrt(1 / sqrt(2))). Far from the step only the colour is left.
TEST(Flip, AddsWhatTheEyeKnowsOfEdges) {
    constexpr int kMiddle = kSize / 2;
    const Picture step = paint([](int x, int) { return x < kMiddle ? kBlack : kWhite; });
    const auto map = flip(uniform(kBlack), step, kSize);
    const auto at = [&](int x) { return map[static_cast<std::size_t>(kMiddle * kSize + x)]; };
    EXPECT_NEAR(at(kSize - 1), expected_of_greys(0, 255), 1e-4);
    EXPECT_NEAR(at(0), 0.0, 1e-9);
    // Beside the step at least half of the white is seen, and at most all.
    const double exponent = 1.0 - std::sqrt(std::sqrt(0.5));
    EXPECT_GT(at(kMiddle), std::pow(expected_of_greys(0, 188), exponent));
    EXPECT_LT(at(kMiddle), std::pow(expected_of_greys(0, 255), exponent));
    EXPECT_GT(at(kMiddle), at(kSize - 1));
    // The same all along the step.
    EXPECT_NEAR(at(kMiddle), map[kMiddle], 1e-12);
}

// A checkerboard as fine as the pixels is grey to the eye, at this distance, but not from nearby.
TEST(Flip, LooksFromAfar) {
    const Picture checks = paint([](int x, int y) { return (x + y) % 2 == 0 ? kBlack : kWhite; });
    const Picture same = uniform(grey(188));  // half of the light
    const auto in_the_middle = [&](double pixels_per_degree) {
        return flip(same, checks, kSize, pixels_per_degree)[kSize * kSize / 2];
    };
    EXPECT_LT(in_the_middle(kPixelsPerDegree), 0.05);
    EXPECT_GT(in_the_middle(8.0), 0.8);
}

TEST(Flip, IsTheSameBothWays) {
    const Picture one = paint([](int x, int y) {
        return DisplayColor{static_cast<std::uint8_t>(6 * x), static_cast<std::uint8_t>(5 * y), 90};
    });
    const Picture other = paint([](int x, int y) { return x * y % 7 == 0 ? kGreen : grey(3 * y); });
    EXPECT_EQ(flip(one, other, kSize), flip(other, one, kSize));
    EXPECT_THAT(flip(one, other, kSize), Each(testing::AllOf(testing::Ge(0.0), testing::Le(1.0))));
}

}  // namespace
}  // namespace lacquer
