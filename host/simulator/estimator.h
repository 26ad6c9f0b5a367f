// Many walks at once, added up in a fixed order: the result depends on seed and count alone, not on
// the number of threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <mutex>
#include <type_traits>
#include <utility>

#include "simulator/random.h"

namespace lacquer::simulator {

struct RunOptions {
    std::uint64_t samples = 1'000'000;
    std::uint64_t seed = 1;
    // Called now and then with the number of walks done, by one thread at a time; false stops the
    // run, keeping what is done.
    std::function<bool(std::uint64_t)> keep_going;
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

// Shared by all blocks of one run.
class RunState {
 public:
    explicit RunState(const RunOptions& options) : options_{options} {}

    bool stopped() const { return stopped_; }

    void finished(std::uint64_t walks) {
        const std::lock_guard lock{mutex_};
        done_ += walks;
        if (options_.keep_going && !options_.keep_going(done_)) stopped_ = true;
    }

 private:
    const RunOptions& options_;
    std::mutex mutex_;
    std::uint64_t done_ = 0;
    std::atomic<bool> stopped_ = false;
};

// Walks that are divided into blocks at a time. A stopped run is soon over, since it passes over
// the blocks of one round only, however many walks were wanted.
inline constexpr std::uint64_t kRound = 1 << 26;

// Runs `walk(random, tally)`, or `walk(random, tally, n)` for walk number n, for every walk and
// returns the merged tally, whose `count` is the number of walks made. Tally: default
// constructible, merge(const Tally&), std::uint64_t count. A tally that takes long to merge wants
// larger blocks.
template <typename Tally, typename Walk>
Tally run_walks(const RunOptions& options, const Walk& walk, std::uint64_t block = 1 << 12) {
    RunState state{options};
    // The tree of merges follows from the range alone.
    struct Body {
        const RunOptions& options;
        const Walk& walk;
        RunState& state;
        Tally tally;

        Body(const RunOptions& run_options, const Walk& one_walk, RunState& run_state)
            : options{run_options}, walk{one_walk}, state{run_state} {}
        Body(const Body& other, tbb::split) : Body{other.options, other.walk, other.state} {}

        void operator()(const tbb::blocked_range<std::uint64_t>& walks) {
            if (state.stopped()) return;
            for (std::uint64_t n = walks.begin(); n < walks.end(); ++n) {
                RandomStream random{options.seed, n};
                if constexpr (std::is_invocable_v<const Walk&, RandomStream&, Tally&,
                                                  std::uint64_t>)
                    walk(random, tally, n);
                else
                    walk(random, tally);
            }
            tally.count += walks.size();
            state.finished(walks.size());
        }

        void join(const Body& right) {
            tally.merge(right.tally);
            tally.count += right.tally.count;
        }
    };
    Body body{options, walk, state};
    for (std::uint64_t first = 0; first < options.samples && !state.stopped(); first += kRound) {
        const std::uint64_t last = first + std::min(kRound, options.samples - first);
        tbb::parallel_deterministic_reduce(tbb::blocked_range<std::uint64_t>{first, last, block},
                                           body, tbb::simple_partitioner{});
    }
    return std::move(body.tally);
}

}  // namespace lacquer::simulator
