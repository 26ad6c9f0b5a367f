// Bakes tables: simulates their dense grids, shared over threads and processes, compresses them and
// writes the files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bake/quantity.h"
#include "bake/ranks.h"

namespace lacquer::bake {

struct BakeRun {
    BakeSettings settings;
    std::filesystem::path folder;  // of the tables and, while a bake runs, its checkpoints
    bool resume = false;           // take over the nodes that an interrupted bake has finished
};

struct BakedTable {
    Table table;
    std::vector<DenseValues> dense;  // one per quantity
};

// Simulates the dense grid of one quantity. The same for any number of threads and processes, and
// for a bake that was resumed. Its checkpoint stays, see discard_checkpoints.
DenseValues simulate(const Quantity& quantity, const Walks& walks, const BakeRun& run,
                     const Ranks& ranks);

// Bakes one table and, in the first process, writes NAME.bin and NAME.exr to the folder. A file
// that is there stays as it was until the new one is whole.
BakedTable bake_table(const TableBake& bake, const Walks& walks, const BakeRun& run,
                      const Ranks& ranks);

// Deletes the checkpoints of a table: for when nothing is left to be done with any, so that a kill
// at any time before loses no finished node.
void discard_checkpoints(const TableBake& bake, const BakeRun& run);

}  // namespace lacquer::bake
