#include "codegen/table_file.h"

#include <fmt/format.h>

#include <span>

#include "codegen/sha256.h"
#include "tables/texels.h"

namespace lacquer::codegen {

namespace {

void append_little_endian(std::string& bytes, std::uint32_t bits) {
    for (int byte = 0; byte < 4; ++byte) bytes += static_cast<char>(bits >> (8 * byte) & 0xff);
}

}  // namespace

TableFile table_file(const std::filesystem::path& folder) {
    const std::vector<TableTexel> texels = pack_texels(read_tables(folder));
    TableFile file;
    file.path = fmt::format("tables/lacquer_tables.{}", file.format);
    file.texel_count = texels.size();
    file.width = kTexelColumns;
    file.height = (texels.size() + kTexelColumns - 1) / kTexelColumns;
    for (std::size_t index = 0; index < file.width * file.height; ++index)
        for (int channel = 0; channel < 4; ++channel)
            append_little_endian(file.contents, index < texels.size() ? texels[index][channel] : 0);
    file.sha256 = sha256(file.contents);
    return file;
}

}  // namespace lacquer::codegen
