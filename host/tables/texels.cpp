#include "tables/texels.h"

#include <algorithm>

#include "core/paths.h"

namespace lacquer {

namespace {

constexpr std::size_t kTexel = 4;

void append(const TableArray& array, std::vector<glm::vec4>& texels) {
    const std::size_t channels = array.channels();
    for (std::size_t node = 0; node < array.values.size(); node += channels)
        for (std::size_t first = 0; first < channels; first += kTexel) {
            glm::vec4 texel{0.0f};
            for (std::size_t n = first; n < std::min(first + kTexel, channels); ++n)
                texel[static_cast<int>(n - first)] = static_cast<float>(array.values[node + n]);
            texels.push_back(texel);
        }
}

// The share that mirrors of each alpha keep of light along the normal: the last cosine of "single".
TableArray normal_energies(const Table& mirror) {
    const TableArray& single = mirror.array("single");
    TableArray energies{"lobe_energy", {single.axes[0], single.axes[2]}, {}};
    const std::size_t cosines = single.axes[1].size;
    for (std::size_t alpha = 0; alpha < single.axes[0].size; ++alpha)
        energies.values.push_back(single.values[alpha * cosines + cosines - 1]);
    return energies;
}

}  // namespace

std::vector<glm::vec4> pack_texels(const std::array<Table, kTableNames.size()>& tables) {
    const auto& [thin, dense, r_up, multiple, conductor, tir, mirror] = tables;
    std::vector<glm::vec4> texels;
    for (const char* name : {"below", "above", "absorption"}) append(thin.array(name), texels);
    for (const char* name : {"above", "absorption"}) append(dense.array(name), texels);
    for (const char* name : {"thin_maps", "thin_absorption", "dense_maps", "dense_absorption"})
        append(r_up.array(name), texels);
    for (const char* name : {"thin_below", "thin_above", "dense_above"})
        append(multiple.array(name), texels);
    append(normal_energies(mirror), texels);
    append(mirror.array("equivalent_alpha"), texels);
    return texels;
}

std::span<const glm::vec4> shipped_texels() {
    static const std::vector<glm::vec4> texels = pack_texels(read_tables(share_file("tables")));
    return texels;
}

}  // namespace lacquer
