#include "bake/bake.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <functional>

#include "bake/checkpoint.h"
#include "bake/picture.h"
#include "core/file.h"
#include "core/progress.h"
#include "image/image_file.h"
#include "tables/table_file.h"

namespace lacquer::bake {

namespace {

// A number that depends on every letter, the same on every machine.
std::uint64_t hash_of(std::string_view text) {
    std::uint64_t hash = 0;
    for (const char letter : text) hash = mix_bits(hash ^ static_cast<unsigned char>(letter)) + 1;
    return hash;
}

std::uint64_t fingerprint_of(const Quantity& quantity, const Walks& walks,
                             const BakeSettings& settings) {
    std::string text = fmt::format("{} {} {} v{}{}", quantity.name, settings.samples, settings.seed,
                                   kTableVersion, walks.backend());
    for (const Axis& axis : quantity.axes)
        text += fmt::format(" {} {} {} {} {}", axis.name, mapping_name(axis.mapping), axis.size,
                            axis.from, axis.to);
    return hash_of(text);
}

std::string checkpoint_prefix(const Quantity& quantity) {
    return quantity.name + ".checkpoint-";
}

std::filesystem::path checkpoint_file(const Quantity& quantity, const BakeRun& run,
                                      const Ranks& ranks) {
    return run.folder /
           fmt::format("{}{}-of-{}", checkpoint_prefix(quantity), ranks.rank() + 1, ranks.count());
}

}  // namespace

DenseValues simulate(const Quantity& quantity, const Walks& walks, const BakeRun& run,
                     const Ranks& ranks) {
    const std::size_t width = quantity.values_per_node();
    const std::uint64_t fingerprint = fingerprint_of(quantity, walks, run.settings);
    Checkpoint checkpoint{checkpoint_file(quantity, run, ranks), fingerprint, width, run.resume};
    DenseValues values(quantity.nodes() * width, 0.0f);
    const std::size_t mine = (quantity.nodes() + ranks.count() - 1 - ranks.rank()) / ranks.count();
    Progress progress{quantity.name, mine};
    const std::span<const Axis> axes = std::span{quantity.axes}.first(quantity.node_axes);
    const auto bake_node = [&](std::size_t index) {
        const std::size_t node = index * ranks.count() + ranks.rank();
        const std::span<float> out{values.data() + node * width, width};
        if (!checkpoint.restore(node, out)) {
            quantity.simulate(grid_parameters(axes, node), walks,
                              mix_bits(fingerprint ^ mix_bits(node + 1)), out);
            checkpoint.record(node, out);
        }
        progress.advance();
    };
    if (walks.concurrent())
        tbb::parallel_for(std::size_t{0}, mine, bake_node);
    else
        for (std::size_t index = 0; index < mine; ++index) bake_node(index);
    ranks.gather(values);
    return values;
}

BakedTable bake_table(const TableBake& bake, const Walks& walks, const BakeRun& run,
                      const Ranks& ranks) {
    const std::filesystem::path file = run.folder / (bake.name + ".bin");
    require_writable(file);
    BakedTable baked;
    for (const Quantity& quantity : bake.quantities)
        baked.dense.push_back(simulate(quantity, walks, run, ranks));
    baked.table = {bake.name,
                   bake.quantity,
                   run.settings.samples,
                   run.settings.seed,
                   std::string{walks.backend()},
                   bake.compress(baked.dense)};
    round_to_encoding(baked.table);
    if (ranks.first()) {
        write_table(file, baked.table);
        write_image(run.folder / (bake.name + ".exr"), picture_of(baked.table),
                    {{"table", bake.name}, {"quantity", bake.quantity}});
    }
    return baked;
}

void discard_checkpoints(const TableBake& bake, const BakeRun& run) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator{run.folder})
        for (const Quantity& quantity : bake.quantities)
            if (entry.path().filename().string().starts_with(checkpoint_prefix(quantity)))
                files.push_back(entry.path());
    for (const std::filesystem::path& file : files) std::filesystem::remove(file);
}

}  // namespace lacquer::bake
