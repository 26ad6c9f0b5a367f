// The processes that share a bake, as `mpirun` starts them.
#pragma once

#include <cstddef>
#include <span>

namespace lacquer::bake {

// One process where the program was not started by mpirun, or was built without MPI. Whoever holds
// it first opens MPI and closes it at the end.
class Ranks {
 public:
    Ranks();
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    std::size_t rank() const { return rank_; }
    std::size_t count() const { return count_; }
    bool first() const { return rank_ == 0; }

    // Every process's values become the sum over all. Each number is 0 in all processes but one, so
    // that the sum is exact.
    void gather(std::span<float> values) const;

 private:
    std::size_t rank_ = 0, count_ = 1;
    bool opened_ = false;
};

}  // namespace lacquer::bake
