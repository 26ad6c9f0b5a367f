#include "image/image_file.h"

#include <gmock/gmock.h>

#include <functional>
#include <limits>

#include "core/error.h"
#include "core/file.h"
#include "image/display.h"
#include "image/png.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// Values that only survive as 32-bit floats, in every channel.
Image test_image() {
    Image image{7, 5};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            image.at(x, y) = {1e-30f * float(x), 1.0f / 3.0f + float(y), 1e20f, float(x) / 7.0f};
    return image;
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Exr, ReturnsEveryFloatAsItWas) {
    const Image image = test_image();
    const ExrPicture read = decode_exr(encode_exr(image, {}), "x.exr");
    ASSERT_EQ(read.image.width, 7);
    ASSERT_EQ(read.image.height, 5);
    EXPECT_EQ(read.image.pixels, image.pixels);
}

TEST(Exr, KeepsItsMetadata) {
    const Metadata metadata{{"material", "gold"}, {"backend", "vulkan"}};
    EXPECT_EQ(decode_exr(encode_exr(test_image(), metadata), "x.exr").metadata, metadata);
}

TEST(Exr, CutAnywhereIsAnErrorThatNamesTheFile) {
    const std::string bytes = encode_exr(test_image(), {});
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const auto decode = [&] { decode_exr(std::string_view{bytes}.substr(0, size), "x.exr"); };
        EXPECT_THAT(message_of(decode), HasSubstr("x.exr")) << size << " of " << bytes.size();
    }
}

TEST(Png, ReturnsEveryLevelAsItWas) {
    const std::vector<DisplayColor> pixels{{0, 1, 2, 255}, {253, 254, 255, 255}, {9, 8, 7, 100}};
    const Image image = decode_png(encode_png(3, 1, pixels), "x.png");
    ASSERT_EQ(image.pixels.size(), 3u);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        EXPECT_EQ(image.pixels[i].x * 255.0f, float(pixels[i].r)) << i;
        EXPECT_EQ(image.pixels[i].w * 255.0f, float(pixels[i].a)) << i;
    }
}

TEST(Png, WithAPaletteShowsItsColours) {
    const std::vector<DisplayColor> palette{{10, 20, 30, 255}, {0, 0, 0, 0}};
    const std::vector<std::uint8_t> indices{0, 1, 1, 0};
    const Image image = decode_png(encode_png(2, 2, indices, palette), "x.png");
    EXPECT_EQ(image.at(1, 1), glm::vec4(10, 20, 30, 255) / 255.0f);
    EXPECT_EQ(image.at(1, 0).w, 0.0f);
}

TEST(Png, CutAnywhereIsAnErrorThatNamesTheFile) {
    const std::string bytes = encode_png(16, 16, std::vector<DisplayColor>(256));
    const std::size_t end_chunk = 12;  // without it the pixels are complete
    for (std::size_t size = 0; size < bytes.size() - end_chunk; ++size) {
        const auto decode = [&] { decode_png(std::string_view{bytes}.substr(0, size), "x.png"); };
        EXPECT_THAT(message_of(decode), HasSubstr("x.png")) << size << " of " << bytes.size();
    }
}

TEST(Png, OfTheWrongSizeIsAnError) {
    EXPECT_THROW(encode_png(3, 2, std::vector<DisplayColor>(5)), Error);
    EXPECT_THROW(encode_png(0, 0, std::vector<DisplayColor>{}), Error);
}

TEST(ImageFile, ChoosesTheFormatByExtensionWhateverItsCase) {
    const TemporaryFolder folder;
    const Image image = test_image();
    write_image(folder / "x.EXR", image, {});
    EXPECT_EQ(read_image(folder / "x.EXR").pixels, image.pixels);
    write_image(folder / "x.png", image, {});
    EXPECT_EQ(read_image(folder / "x.png").width, image.width);
}

TEST(ImageFile, PngHoldsWhatADisplayShows) {
    const TemporaryFolder folder;
    Image image{1, 1};
    image.at(0, 0) = {0.5f, 1.0f, 4.0f, 1.0f};
    write_image(folder / "x.png", image, {});
    const DisplayColor shown = display_color(image.at(0, 0));
    EXPECT_EQ(read_image(folder / "x.png").at(0, 0),
              glm::vec4(shown.r, shown.g, shown.b, shown.a) / 255.0f);
}

TEST(ImageFile, AnotherExtensionIsAnErrorThatListsTheFormats) {
    const TemporaryFolder folder;
    EXPECT_THROW(require_image_output(folder / "x.jpg"), UsageError);
    EXPECT_THROW(write_image(folder / "x.jpg", test_image(), {}), UsageError);
    EXPECT_THAT(message_of([&] { read_image(folder / "x.tiff"); }), HasSubstr(".exr, .png"));
    EXPECT_THAT(folder.entries(), IsEmpty());
}

TEST(ImageFile, BytesThatAreNoPictureAreAnError) {
    const TemporaryFolder folder;
    write_file(folder / "x.exr", "this is text");
    write_file(folder / "x.png", "this is text");
    EXPECT_THAT(message_of([&] { read_image(folder / "x.exr"); }), HasSubstr("x.exr"));
    EXPECT_THAT(message_of([&] { read_image(folder / "x.png"); }), HasSubstr("x.png"));
}

TEST(ImageFile, AnUnwritableOutputIsAnErrorAndLeavesNothing) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_image(folder / "no/x.exr", test_image(), {}), Error);
    EXPECT_THROW(require_image_output(folder / "no/x.exr"), Error);
    EXPECT_THAT(folder.entries(), IsEmpty());
}

}  // namespace
}  // namespace lacquer
