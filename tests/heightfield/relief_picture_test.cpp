// Pictures of heightfields and cuts through them.
#include "heightfield/relief_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "heightfield/surfaces.h"

namespace lacquer::heightfield {
namespace {

constexpr FieldGrid kGrid{64, 8.0};
constexpr Rgb kRed{1.0, 0.0, 0.0}, kBlue{0.0, 0.0, 1.0};

TEST(ReliefPicture, AFlatSurfaceIsEvenlyLit) {
    const Heightfield surface{test::uniform(0.0), kGrid, 1, 0};
    const Image image = relief_picture(surface, std::vector<Rgb>{kRed}, {24, 16, 100.0});
    for (const glm::vec4& pixel : image.pixels) {
        EXPECT_GT(pixel.x, 0.0f);
        EXPECT_EQ(pixel, image.pixels.front());
    }
}

TEST(ReliefPicture, StrataHaveTheirColorsAndFillThePicture) {
    const Heightfield surface{test::two_strata(0.91, 0.364), kGrid, 1, 0};
    const Image image = relief_picture(surface, std::vector<Rgb>{kRed, kBlue}, {60, 40, 60.0});
    int red = 0, blue = 0;
    for (const glm::vec4& pixel : image.pixels) {
        EXPECT_EQ(pixel.y, 0.0f);
        EXPECT_GT(pixel.x + pixel.z, 0.0f);
        red += pixel.x > pixel.z ? 1 : 0;
        blue += pixel.z > pixel.x ? 1 : 0;
    }
    EXPECT_GT(red, 0);
    EXPECT_GT(blue, 0);
}

// Over a period the cut comes back to where it was, within the heights of the surface.
TEST(ReliefPicture, TheCutIsThatOfThePeriodicSurface) {
    const Heightfield surface{test::two_strata(0.91, 0.364), kGrid, 1, 0};
    const auto profile = relief_profile(surface, kGrid.cells, kGrid.cells + 1);
    ASSERT_EQ(profile.size(), static_cast<std::size_t>(kGrid.cells + 1));
    EXPECT_NEAR(profile.front().y, profile.back().y, 1e-5);  // Embree's floats
    for (const glm::dvec2& point : profile) {
        EXPECT_GE(point.y, surface.mesh().lowest - 1e-5);
        EXPECT_LE(point.y, surface.mesh().highest + 1e-5);
    }
}

}  // namespace
}  // namespace lacquer::heightfield
