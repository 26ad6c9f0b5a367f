// Many walks at once, added up in a fixed order: the result depends on seed and count alone, not on
// the number of threads.
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

#include "simulator/random.h"

namespace lacquer::simulator {

struct RunOptions {
    std::uint64_t samples = 1'000'000;
    std::uint64_t seed = 1;
    // Called now and then with the share of walks done; false stops the run, keeping what is done.
    std::function<bool(double)> keep_going;
};

// Sum and sum of squares of a quantity over walks.
struct Moments {
    double sum = 0.0;
    double squares = 0.0;

    void add(double value) {
        sum += value;
        squares += value * value;
    }

    void merge(const Moments& other) {
        sum += other.sum;
        squares += other.squares;
    }

    double mean(double count) const { return sum / count; }

    // Standard error of the mean over `count` walks, those that added nothing included.
    double standard_error(double count) const {
        const double average = mean(count);
        return std::sqrt(std::max(0.0, squares / count - average * average) / count);
    }
};

// Runs `walk(random, tally)` for every walk and returns the merged tally, whose `count` is the
// number of walks made. Tally: default constructible, merge(const Tally&), std::uint64_t count.
template <typename Tally, typename Walk>
Tally run_walks(const RunOptions& options, const Walk& walk) {
    constexpr std::uint64_t kBlock = 1 << 12;
    constexpr std::uint64_t kWave = 256;  // blocks between two looks at keep_going
    const std::uint64_t blocks = (options.samples + kBlock - 1) / kBlock;
    Tally total;
    for (std::uint64_t wave = 0; wave < blocks; wave += kWave) {
        std::vector<Tally> tallies(std::min(kWave, blocks - wave));
        tbb::parallel_for(std::size_t{0}, tallies.size(), [&](std::size_t index) {
            const std::uint64_t first = (wave + index) * kBlock;
            const std::uint64_t last = std::min(first + kBlock, options.samples);
            Tally& tally = tallies[index];
            for (std::uint64_t n = first; n < last; ++n) {
                RandomStream random{options.seed, n};
                walk(random, tally);
            }
            tally.count = last - first;
        });
        for (const Tally& tally : tallies) {
            total.merge(tally);
            total.count += tally.count;
        }
        const double done = static_cast<double>(total.count) / static_cast<double>(options.samples);
        if (options.keep_going && !options.keep_going(done)) break;
    }
    return total;
}

}  // namespace lacquer::simulator
