// The finished nodes of a bake on disk, so that a bake that was killed goes on where it was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <span>
#include <vector>

namespace lacquer::bake {

// A file of records, one per node, each with its own checksum: a record cut short by a kill is
// dropped on reading.
class Checkpoint {
 public:
    // `fingerprint` tells bakes apart: records of another are not taken over. Without `resume` an
    // old file is replaced. Throws Error naming the file where it cannot be written.
    Checkpoint(std::filesystem::path file, std::uint64_t fingerprint, std::size_t values_per_node,
               bool resume);

    // Whether the node was baked before; if so its values are in `values`.
    bool restore(std::size_t node, std::span<float> values) const;

    // Safe to call from several threads.
    void record(std::size_t node, std::span<const float> values);

 private:
    void read();
    std::size_t record_bytes() const;

    std::filesystem::path file_;
    std::uint64_t fingerprint_;
    std::size_t values_per_node_;
    std::vector<std::uint64_t> nodes_;
    std::vector<float> values_;
    std::ofstream stream_;
    std::mutex mutex_;
};

}  // namespace lacquer::bake
