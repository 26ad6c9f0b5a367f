#include "image/exr.h"

#include <ImathBox.h>
#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfThreading.h>
#include <fmt/format.h>

#include <cstring>

#include "core/error.h"

namespace lacquer {

namespace {

constexpr std::string_view kPrefix = "lacquer:";
constexpr std::int64_t kMaxPixels = std::int64_t{1} << 28;  // 4 GiB of pixels: a damaged header

class MemoryWriter : public Imf::OStream {
 public:
    MemoryWriter() : Imf::OStream{"memory"} {}

    void write(const char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (position_ + size > bytes_.size()) bytes_.resize(position_ + size);
        std::memcpy(bytes_.data() + position_, bytes, size);
        position_ += size;
    }
    uint64_t tellp() override { return position_; }
    void seekp(uint64_t position) override { position_ = position; }

    std::string take() { return std::move(bytes_); }

 private:
    std::string bytes_;
    std::size_t position_ = 0;
};

class MemoryReader : public Imf::IStream {
 public:
    explicit MemoryReader(std::string_view bytes) : Imf::IStream{"memory"}, bytes_{bytes} {}

    bool read(char bytes[], int count) override {
        const auto size = static_cast<std::size_t>(count);
        if (position_ > bytes_.size() || size > bytes_.size() - position_)
            throw Error{"it ends too soon"};
        std::memcpy(bytes, bytes_.data() + position_, size);
        position_ += size;
        return position_ < bytes_.size();
    }
    uint64_t tellg() override { return position_; }
    void seekg(uint64_t position) override { position_ = position; }

 private:
    std::string_view bytes_;
    std::size_t position_ = 0;
};

// Where OpenEXR finds channel `index` of pixel (x, y), for x and y of the file's data window.
Imf::Slice float_slice(Image& image, const Imath::V2i& first, int index, double fill) {
    const std::size_t x_stride = sizeof(glm::vec4);
    const std::size_t y_stride = x_stride * static_cast<std::size_t>(image.width);
    char* base = reinterpret_cast<char*>(image.pixels.data()) + index * sizeof(float);
    base -= first.x * static_cast<std::ptrdiff_t>(x_stride);
    base -= first.y * static_cast<std::ptrdiff_t>(y_stride);
    return {Imf::FLOAT, base, x_stride, y_stride, 1, 1, fill};
}

Image sized_for(const Imath::Box2i& window) {
    const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
    const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
    if (width <= 0 || height <= 0 || width > kMaxPixels / height)
        throw Error{fmt::format("its size, {} x {} pixels, is not believable", width, height)};
    return {static_cast<int>(width), static_cast<int>(height)};
}

Image read_pixels(Imf::InputFile& file) {
    const Imath::Box2i window = file.header().dataWindow();
    const Imf::ChannelList& channels = file.header().channels();
    const bool grey = channels.findChannel("Y") != nullptr && channels.findChannel("R") == nullptr;
    if (!grey && channels.findChannel("R") == nullptr && channels.findChannel("G") == nullptr &&
        channels.findChannel("B") == nullptr && channels.findChannel("A") == nullptr)
        throw Error{"it has none of the channels R, G, B, A, Y"};
    Image image = sized_for(window);
    Imf::FrameBuffer frame;
    frame.insert(grey ? "Y" : "R", float_slice(image, window.min, 0, 0.0));
    if (!grey) frame.insert("G", float_slice(image, window.min, 1, 0.0));
    if (!grey) frame.insert("B", float_slice(image, window.min, 2, 0.0));
    frame.insert("A", float_slice(image, window.min, 3, 1.0));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    if (grey)
        for (glm::vec4& pixel : image.pixels) pixel.z = pixel.y = pixel.x;
    return image;
}

Metadata read_metadata(const Imf::Header& header) {
    Metadata metadata;
    for (auto i = header.begin(); i != header.end(); ++i) {
        const std::string_view name = i.name();
        const auto* text = dynamic_cast<const Imf::StringAttribute*>(&i.attribute());
        if (text != nullptr && name.starts_with(kPrefix))
            metadata.emplace(name.substr(kPrefix.size()), text->value());
    }
    return metadata;
}

}  // namespace

std::string encode_exr(const Image& image, const Metadata& metadata) {
    if (image.pixels.empty()) throw Error{"writing an EXR: the picture has no pixels"};
    Imf::Header header{image.width, image.height};
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    Image& pixels = const_cast<Image&>(image);  // OpenEXR only reads them, but does not say so
    for (int channel = 0; channel < 4; ++channel) {
        const char name[] = {"RGBA"[channel], '\0'};
        header.channels().insert(name, Imf::Channel{Imf::FLOAT});
        frame.insert(name, float_slice(pixels, {0, 0}, channel, 0.0));
    }
    for (const auto& [key, value] : metadata)
        header.insert(std::string{kPrefix} + key, Imf::StringAttribute{value});
    MemoryWriter writer;
    {
        Imf::OutputFile file{writer, header};
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    }  // the file is complete when OutputFile is gone
    return writer.take();
}

ExrPicture decode_exr(std::string_view bytes, std::string_view origin) {
    try {
        MemoryReader reader{bytes};
        Imf::InputFile file{reader};
        return {read_pixels(file), read_metadata(file.header())};
    } catch (const std::exception& error) {
        throw Error{fmt::format("reading '{}': not a readable EXR: {}", origin, error.what())};
    }
}

}  // namespace lacquer
