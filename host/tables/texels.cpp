#include "tables/texels.h"

#include <Imath/half.h>

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/paths.h"

namespace lacquer {

namespace {

constexpr std::size_t kTexel = 8;

// As many texels as the numbers of one node take, the last filled up with 0.
void append_node(std::span<const double> numbers, std::vector<TableTexel>& texels) {
    for (std::size_t first = 0; first < numbers.size(); first += kTexel) {
        TableTexel texel{0};
        for (std::size_t n = first; n < std::min(first + kTexel, numbers.size()); ++n) {
            const std::uint32_t bits = Imath::half{static_cast<float>(numbers[n])}.bits();
            texel[static_cast<int>((n - first) / 2)] |= bits << (n % 2 * 16);
        }
        texels.push_back(texel);
    }
}

std::span<const double> node_of(const TableArray& array, std::size_t node) {
    return std::span{array.values}.subspan(node * array.channels(), array.channels());
}

std::size_t node_count(const TableArray& array) {
    return array.values.size() / array.channels();
}

void append(const TableArray& array, std::vector<TableTexel>& texels) {
    for (std::size_t node = 0; node < node_count(array); ++node)
        append_node(node_of(array, node), texels);
}

// Coefficients of T01: a texel for each function of tau.
void append_coefficients(const TableArray& array, const CoefficientCounts& counts,
                         std::vector<TableTexel>& texels) {
    for (std::size_t node = 0; node < node_count(array); ++node) {
        std::size_t first = 0;
        for (const std::size_t count : counts) {
            append_node(node_of(array, node).subspan(first, count), texels);
            first += count;
        }
    }
}

// Functions of tau: a texel for those of T01 and one for those of R10_bar.
void append_absorption(const TableArray& t_down, const TableArray& r_up,
                       std::vector<TableTexel>& texels) {
    for (std::size_t node = 0; node < node_count(t_down); ++node) {
        append_node(node_of(t_down, node), texels);
        append_node(node_of(r_up, node), texels);
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

std::vector<TableTexel> pack_texels(const std::array<Table, kTableNames.size()>& tables) {
    const auto& [thin, dense, r_up, multiple, conductor, tir, mirror, lobes] = tables;
    std::vector<TableTexel> texels;
    append_coefficients(thin.array("below"), kThinCoefficients, texels);
    append_coefficients(thin.array("above"), kThinCoefficients, texels);
    append_coefficients(dense.array("above"), kDenseCoefficients, texels);
    append_absorption(thin.array("absorption"), r_up.array("thin_absorption"), texels);
    append_absorption(dense.array("absorption"), r_up.array("dense_absorption"), texels);
    for (const char* name : {"thin_maps", "dense_maps"}) append(r_up.array(name), texels);
    for (const char* name : {"thin_below", "thin_above", "dense_above"})
        append(multiple.array(name), texels);
    append(normal_energies(mirror), texels);
    append(mirror.array("equivalent_alpha"), texels);
    append(clear_coefficients(thin, "below", Contrast::thin), texels);
    append(clear_coefficients(thin, "above", Contrast::thin), texels);
    append(clear_coefficients(dense, "above", Contrast::dense), texels);
    for (const char* name : {"facets", "materials"}) append(conductor.array(name), texels);
    append(lobes.array("nodes"), texels);
    return texels;
}

std::span<const TableTexel> shipped_texels() {
    static const std::vector<TableTexel> texels = pack_texels(read_tables(share_file("tables")));
    return texels;
}

}  // namespace lacquer
