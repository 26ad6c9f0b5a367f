// The packed tables as a file, read back as an engine would.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "check.h"
#include "shading/table_texels.h"

namespace lacquer::test {
namespace {

using codegen::TableFile;

const TableFile& table() {
    return everything().tables.front();
}

// Texel (x, y) of a texture that the file was uploaded to.
glm::uvec4 texel_at(const TableFile& file, std::size_t x, std::size_t y) {
    glm::uvec4 texel;
    std::memcpy(&texel, file.contents.data() + (y * file.width + x) * sizeof(texel), sizeof(texel));
    return texel;
}

TEST(Tables, HoldTheTexelsOfTheLibrary) {
    const TableFile& file = table();
    EXPECT_EQ(file.texel_count, kTableTexelCount);
    ASSERT_EQ(file.contents.size(), sizeof(glm::uvec4) * file.width * file.height);
    ASSERT_GE(file.width * file.height, file.texel_count);
    for (std::size_t i = 0; i < file.width * file.height; ++i) {
        const glm::uvec4 expected = i < kTableTexelCount ? kTableTexels[i] : glm::uvec4{0};
        EXPECT_EQ(texel_at(file, i % file.width, i / file.width), expected) << i;
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
    constexpr std::string_view kPath = "glsl450/kernel/coated_sphere_view.frag.glsl";
    const auto file = std::ranges::find(everything().files, kPath, &codegen::ShaderFile::path);
    ASSERT_NE(file, everything().files.end());
    EXPECT_THAT(file->contents, testing::HasSubstr("LQ_TABLE_COLUMNS = " +
                                                   std::to_string(table().width) + ";"));
}

}  // namespace
}  // namespace lacquer::test
