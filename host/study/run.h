// How much a study simulates, and from which numbers.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "simulator/estimator.h"

namespace lacquer::study {

// Walks of light in each simulated picture. Curves and numbers take a share of it.
inline constexpr std::uint64_t kDefaultSamples = 1 << 22;
// With fewer, parts of a figure may see no light at all.
inline constexpr std::uint64_t kLeastSamples = 1 << 12;

struct StudyRun {
    std::uint64_t samples = kDefaultSamples;
    std::uint64_t seed = 1;
    std::function<void(std::string_view)> on_part{};  // told what is computed next

    void part(std::string_view what) const {
        if (on_part) on_part(what);
    }

    // A share of the walks of a picture, at least one.
    std::uint64_t share(std::uint64_t divisor) const {
        return std::max<std::uint64_t>(samples / divisor, 1);
    }

    // The seed of one simulation, by its name: the others' stay as they are when one is added.
    std::uint64_t seed_of(std::string_view name) const {
        std::uint64_t hash = 0xcbf29ce484222325u ^ seed;  // FNV-1a
        for (const char c : name) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
        return hash;
    }

    simulator::RunOptions options(std::uint64_t walks, std::string_view name) const {
        return {walks, seed_of(name), {}};
    }
};

}  // namespace lacquer::study
