#include "codegen/table_files.h"

#include <fmt/format.h>

#include <bit>
#include <glm/gtc/packing.hpp>
#include <span>

#include "codegen/sha256.h"
#include "tables/texels.h"

namespace lacquer::codegen {

namespace {

template <typename Bits>
void append_little_endian(std::string& bytes, Bits bits) {
    for (std::size_t byte = 0; byte < sizeof(Bits); ++byte)
        bytes += static_cast<char>(bits >> (8 * byte) & 0xff);
}

TableFile table_file(std::string_view format, std::span<const glm::vec4> texels,
                     void (*append)(std::string& bytes, float value)) {
    TableFile file;
    file.format = format;
    file.path = fmt::format("tables/lacquer_tables.{}", format);
    file.texel_count = texels.size();
    file.width = kTexelColumns;
    file.height = (texels.size() + kTexelColumns - 1) / kTexelColumns;
    for (std::size_t index = 0; index < file.width * file.height; ++index)
        for (int channel = 0; channel < 4; ++channel)
            append(file.contents, index < texels.size() ? texels[index][channel] : 0.0f);
    file.sha256 = sha256(file.contents);
    return file;
}

}  // namespace

std::vector<TableFile> table_files(const std::filesystem::path& folder) {
    const std::vector<glm::vec4> texels = pack_texels(read_tables(folder));
    return {table_file("rgba16f", texels,
                       [](std::string& bytes, float value) {
                           append_little_endian(bytes, glm::packHalf1x16(value));
                       }),
            table_file("rgba32f", texels, [](std::string& bytes, float value) {
                append_little_endian(bytes, std::bit_cast<std::uint32_t>(value));
            })};
}

}  // namespace lacquer::codegen
