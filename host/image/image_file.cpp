#include "image/image_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "image/display.h"
#include "image/png.h"

namespace lacquer {

namespace {

enum class Format { exr, png };

std::optional<Format> format_of(const std::filesystem::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (extension == ".exr") return Format::exr;
    if (extension == ".png") return Format::png;
    return std::nullopt;
}

std::string format_message(std::string_view doing, const std::filesystem::path& file) {
    return fmt::format("{} '{}': the extension '{}' is not one of: .exr, .png", doing,
                       file.string(), file.extension().string());
}

}  // namespace

void require_image_output(const std::filesystem::path& file) {
    if (!format_of(file)) throw UsageError{format_message("writing", file)};
    require_writable(file);
}

bool is_display_format(const std::filesystem::path& file) {
    return format_of(file) == Format::png;
}

void write_image(const std::filesystem::path& file, const Image& image, const Metadata& metadata) {
    const auto format = format_of(file);
    if (!format) throw UsageError{format_message("writing", file)};
    if (*format == Format::exr) return write_file(file, encode_exr(image, metadata));
    write_file(file, encode_png(image.width, image.height, display_pixels(image)));
}

Image read_image(const std::filesystem::path& file) {
    const auto format = format_of(file);
    if (!format) throw Error{format_message("reading", file)};
    const std::string bytes = read_file(file);
    if (*format == Format::exr) return decode_exr(bytes, file.string()).image;
    return decode_png(bytes, file.string());
}

}  // namespace lacquer
