#include "image/png.h"

#include <fmt/format.h>
#include <png.h>

#include "core/error.h"

namespace lacquer {

namespace {

// libpng's description of one picture, freed on every way out.
class PngImage {
 public:
    PngImage() { image_.version = PNG_IMAGE_VERSION; }
    PngImage(int width, int height, std::uint32_t format) : PngImage{} {
        image_.width = static_cast<png_uint_32>(width);
        image_.height = static_cast<png_uint_32>(height);
        image_.format = format;
    }
    ~PngImage() { png_image_free(&image_); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;

    png_image* get() { return &image_; }
    png_image* operator->() { return &image_; }

 private:
    png_image image_{};
};

void require_size(int width, int height, std::size_t pixels) {
    if (width > 0 && height > 0 &&
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) == pixels)
        return;
    throw Error{fmt::format("writing a PNG: {} x {} pixels, but {} given", width, height, pixels)};
}

std::string encode(PngImage& image, const void* pixels, const void* palette) {
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(*image.get());
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(image.get(), bytes.data(), &size, 0, pixels, 0, palette) == 0)
        throw Error{fmt::format("writing a PNG: {}", image->message)};
    bytes.resize(size);
    return bytes;
}

}  // namespace

std::string encode_png(int width, int height, std::span<const DisplayColor> pixels) {
    static_assert(sizeof(DisplayColor) == 4);
    require_size(width, height, pixels.size());
    PngImage image{width, height, PNG_FORMAT_RGBA};
    return encode(image, pixels.data(), nullptr);
}

std::string encode_png(int width, int height, std::span<const std::uint8_t> indices,
                       std::span<const DisplayColor> palette) {
    require_size(width, height, indices.size());
    PngImage image{width, height, PNG_FORMAT_RGBA_COLORMAP};
    image->colormap_entries = static_cast<png_uint_32>(palette.size());
    return encode(image, indices.data(), palette.data());
}

Image decode_png(std::string_view bytes, std::string_view origin) {
    PngImage image;
    const auto fail = [&] {
        throw Error{fmt::format("reading '{}': not a readable PNG: {}", origin, image->message)};
    };
    if (png_image_begin_read_from_memory(image.get(), bytes.data(), bytes.size()) == 0) fail();
    image->format = PNG_FORMAT_RGBA;
    image->flags |= PNG_IMAGE_FLAG_16BIT_sRGB;
    std::vector<DisplayColor> colors(std::size_t{image->width} * image->height);
    if (png_image_finish_read(image.get(), nullptr, colors.data(), 0, nullptr) == 0) fail();
    Image result{static_cast<int>(image->width), static_cast<int>(image->height)};
    for (std::size_t i = 0; i < colors.size(); ++i)
        result.pixels[i] = glm::vec4{colors[i].r, colors[i].g, colors[i].b, colors[i].a} / 255.0f;
    return result;
}

}  // namespace lacquer
