// Writes the texels of the baked tables as C++ source, for the library to carry them:
// lacquer-embed-texels TABLES OUTPUT.
#include <fmt/format.h>

#include <cstdio>
#include <iterator>

#include "core/error.h"
#include "core/file.h"
#include "tables/texels.h"

namespace {

using namespace lacquer;

std::string source_of(std::span<const TableTexel> texels) {
    std::string source = "// Generated from tables/*.bin.\n#include \"shading/table_texels.h\"\n\n";
    fmt::format_to(std::back_inserter(source),
                   "namespace lacquer {{\n\n"
                   "const std::size_t kTableTexelCount = {};\n\n"
                   "const glm::uvec4 kTableTexels[] = {{\n",
                   texels.size());
    for (const TableTexel& texel : texels)
        fmt::format_to(std::back_inserter(source), "{{{:#x},{:#x},{:#x},{:#x}}},\n", texel.x,
                       texel.y, texel.z, texel.w);
    return source + "};\n\n}  // namespace lacquer\n";
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 3) {
        fmt::print(stderr, "usage: lacquer-embed-texels TABLES OUTPUT\n");
        return 2;
    }
    try {
        write_file(arguments[2], source_of(pack_texels(read_tables(arguments[1]))));
        return 0;
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
