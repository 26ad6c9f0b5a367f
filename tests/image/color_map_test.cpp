#include "image/color_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace lacquer {
namespace {

// A polynomial of degree 6 departs from the table; this many levels of 255 cannot be seen.
constexpr int kFitLevels = 4;

// CIE 1976 lightness of an sRGB colour, 0 to 100.
double lightness(const DisplayColor& color) {
    const double y = 0.2126 * srgb_decode(color.r / 255.0) + 0.7152 * srgb_decode(color.g / 255.0) +
                     0.0722 * srgb_decode(color.b / 255.0);
    return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

void expect_near(const DisplayColor& color, int r, int g, int b) {
    EXPECT_NEAR(color.r, r, kFitLevels);
    EXPECT_NEAR(color.g, g, kFitLevels);
    EXPECT_NEAR(color.b, b, kFitLevels);
}

TEST(HeatColor, MeetsThePublishedTable) {
    expect_near(heat_color(0.0), 0x00, 0x00, 0x04);
    expect_near(heat_color(0.5), 0xbc, 0x37, 0x54);
    expect_near(heat_color(1.0), 0xfc, 0xff, 0xa4);
}

TEST(HeatColor, GrowsLighterAllTheWay) {
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i)
        EXPECT_LT(lightness(heat_color(double(i) / kSteps)),
                  lightness(heat_color(double(i + 1) / kSteps)))
            << i;
}

TEST(HeatColor, ClampsOutsideItsRange) {
    EXPECT_EQ(heat_color(-1.0), heat_color(0.0));
    EXPECT_EQ(heat_color(std::numeric_limits<double>::infinity()), heat_color(1.0));
}

TEST(HeatColor, ShowsWhatIsNotANumberInAColourOfItsOwn) {
    EXPECT_EQ(heat_color(std::nan("")), kNotANumberColor);
    for (int i = 0; i <= 255; ++i) EXPECT_NE(heat_color(i / 255.0), kNotANumberColor);
}

TEST(DifferenceColor, GrowsLighterToBothSides) {
    constexpr int kSteps = 64;
    for (int i = 0; i < kSteps; ++i)
        for (const double side : {-1.0, 1.0})
            EXPECT_LT(lightness(difference_color(side * i / kSteps)),
                      lightness(difference_color(side * (i + 1) / kSteps)))
                << side * i;
}

TEST(DifferenceColor, TellsTooLittleFromTooMuch) {
    const DisplayColor less = difference_color(-0.5), more = difference_color(0.5);
    EXPECT_GT(less.b, less.r);
    EXPECT_GT(more.r, more.b);
    EXPECT_EQ(difference_color(0.0), (DisplayColor{0, 0, 0, 255}));
    EXPECT_EQ(difference_color(-7.0), difference_color(-1.0));
    EXPECT_EQ(difference_color(std::nan("")), kNotANumberColor);
}

}  // namespace
}  // namespace lacquer
