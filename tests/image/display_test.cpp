#include "image/display.h"

#include <gtest/gtest.h>

#include <cmath>

namespace lacquer {
namespace {

constexpr double kRounding = 1e-12;

TEST(ToneCurve, IsOneMinusTheExponential) {
    EXPECT_DOUBLE_EQ(tone_curve(1.0), 1.0 - std::exp(-1.0));
    EXPECT_EQ(tone_curve(0.0), 0.0);
    EXPECT_EQ(tone_curve(1e30), 1.0);
}

TEST(ToneCurve, TreatsNegativeRadianceAsNone) {
    EXPECT_EQ(tone_curve(-2.0), 0.0);
}

// The ends of IEC 61966-2-1's curve, and level 118 for a grey card of 18 %.
TEST(SrgbEncode, MeetsTheStandard) {
    EXPECT_EQ(srgb_encode(0.0), 0.0);
    EXPECT_NEAR(srgb_encode(1.0), 1.0, kRounding);
    EXPECT_EQ(std::lround(255.0 * srgb_encode(0.18)), 118);
}

TEST(SrgbEncode, JoinsItsTwoPartsWithoutAStep) {
    // The standard's rounded constants leave a step of 3e-8.
    EXPECT_NEAR(srgb_encode(0.0031308), srgb_encode(std::nextafter(0.0031308, 1.0)), 1e-7);
}

TEST(SrgbDecode, UndoesEncoding) {
    for (int i = 0; i <= 255; ++i)
        EXPECT_NEAR(srgb_encode(srgb_decode(i / 255.0)), i / 255.0, 1e-7) << i;
}

TEST(DisplayColor, DividesByAlpha) {
    const DisplayColor whole = display_color({0.5f, 1.0f, 2.0f, 1.0f});
    const DisplayColor half = display_color({0.25f, 0.5f, 1.0f, 0.5f});
    EXPECT_EQ(half, (DisplayColor{whole.r, whole.g, whole.b, 128}));
}

TEST(DisplayColor, LeavesWhatWasNotComputedTransparent) {
    EXPECT_EQ(display_color({0, 0, 0, 0}), (DisplayColor{0, 0, 0, 0}));
}

TEST(DisplayColor, ShowsWhatIsNotANumber) {
    EXPECT_EQ(display_color({NAN, 0, 0, 1}), kNotANumberColor);
}

}  // namespace
}  // namespace lacquer
