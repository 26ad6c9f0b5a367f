#include "image/texture.h"

#include <gtest/gtest.h>

namespace lacquer {
namespace {

// Red: 0 1 / 2 3, rows from the top.
Image two_by_two() {
    Image image{2, 2};
    for (int i = 0; i < 4; ++i) image.at(i % 2, i / 2) = {float(i), 0.0f, 0.0f, 10.0f};
    return image;
}

TEST(SampleTexture, IsExactAtPixelCentresWithVUpwards) {
    const Image image = two_by_two();
    EXPECT_EQ(sample_texture(image, 'r', {0.25, 0.75}), 0.0);
    EXPECT_EQ(sample_texture(image, 'r', {0.75, 0.75}), 1.0);
    EXPECT_EQ(sample_texture(image, 'r', {0.25, 0.25}), 2.0);
    EXPECT_EQ(sample_texture(image, 'r', {0.75, 0.25}), 3.0);
}

TEST(SampleTexture, IsTheMeanBetweenThem) {
    EXPECT_DOUBLE_EQ(sample_texture(two_by_two(), 'r', {0.5, 0.5}), 1.5);
}

TEST(SampleTexture, RepeatsInUAndClampsInV) {
    const Image image = two_by_two();
    EXPECT_DOUBLE_EQ(sample_texture(image, 'r', {0.0, 0.75}), 0.5);
    EXPECT_DOUBLE_EQ(sample_texture(image, 'r', {1.25, 0.75}), 0.0);
    EXPECT_DOUBLE_EQ(sample_texture(image, 'r', {-0.25, 0.75}), 1.0);
    EXPECT_DOUBLE_EQ(sample_texture(image, 'r', {0.25, 1.5}), 0.0);
    EXPECT_DOUBLE_EQ(sample_texture(image, 'r', {0.25, -0.5}), 2.0);
}

TEST(SampleTexture, ReadsTheChannelAskedFor) {
    EXPECT_EQ(sample_texture(two_by_two(), 'a', {0.3, 0.4}), 10.0);
    EXPECT_EQ(sample_texture(two_by_two(), 'g', {0.3, 0.4}), 0.0);
}

}  // namespace
}  // namespace lacquer
