// The packed tables as files, read back as an engine would.
#include <gmock/gmock.h>

#include <cstring>
#include <glm/gtc/packing.hpp>
#include <nlohmann/json.hpp>

#include "check.h"
#include "shading/table_texels.h"

namespace lacquer::test {
namespace {

using codegen::TableFile;

const TableFile& table(const std::string& format) {
    for (const TableFile& file : everything().tables)
        if (file.format == format) return file;
    throw std::runtime_error{"no tables of format " + format};
}

// Texel (x, y) of a texture that the file was uploaded to.
glm::vec4 texel_at(const TableFile& file, std::size_t x, std::size_t y) {
    const char* const first =
        file.contents.data() + (y * file.width + x) * (file.format == "rgba32f" ? 16 : 8);
    glm::vec4 texel;
    for (int channel = 0; channel < 4; ++channel) {
        if (file.format == "rgba32f") {
            std::memcpy(&texel[channel], first + 4 * channel, 4);
        } else {
            std::uint16_t half = 0;
            std::memcpy(&half, first + 2 * channel, 2);
            texel[channel] = glm::unpackHalf1x16(half);
        }
    }
    return texel;
}

TEST(Tables, HoldTheTexelsOfTheLibraryInEveryFormat) {
    for (const auto& [format, bytes] : {std::pair{"rgba16f", 8}, {"rgba32f", 16}}) {
        const TableFile& file = table(format);
        EXPECT_EQ(file.texel_count, kTableTexelCount);
        ASSERT_EQ(file.contents.size(), bytes * file.width * file.height);
        ASSERT_GE(file.width * file.height, file.texel_count);
        for (std::size_t i = 0; i < file.width * file.height; ++i) {
            const glm::vec4 expected = i < kTableTexelCount ? kTableTexels[i] : glm::vec4{0.0f};
            EXPECT_EQ(texel_at(file, i % file.width, i / file.width), expected) << format << i;
        }
    }
}

TEST(Tables, StandInTheManifestWithTheFilesThatReadThem) {
    const auto manifest = nlohmann::json::parse(codegen::manifest(everything()));
    for (const auto& file : manifest.at("files")) {
        const bool reads = file.at("table_reads") > 0;
        EXPECT_EQ(file.at("tables").size(), reads ? 1u : 0u) << file.at("path");
        if (reads) {
            EXPECT_EQ(file.at("tables")[0], manifest.at("tables")[0].at("name"));
        }
    }
}

TEST(Tables, AreLeftOutWhereNothingReadsThem) {
    codegen::Request request;
    request.source_root = SHADER_SOURCE;
    request.tables_folder = BAKED_TABLES;
    request.targets = {codegen::Target::glsl450};
    request.levels = {"plain"};
    EXPECT_TRUE(codegen::generate(request).tables.empty());
}

TEST(Tables, TheViewersTextureHasAsManyColumnsAsTheFiles) {
    for (const codegen::ShaderFile& file : everything().files)
        if (file.path == "glsl450/kernel/coated_sphere_view.frag.glsl") {
            EXPECT_THAT(file.contents,
                        testing::HasSubstr(
                            "LQ_TABLE_COLUMNS = " + std::to_string(table("rgba16f").width) + ";"));
        }
}

}  // namespace
}  // namespace lacquer::test
