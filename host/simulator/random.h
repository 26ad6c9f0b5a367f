// Random numbers of a walk: a counter-based stream, so that walk n of seed s draws the same numbers
// whichever thread runs it.
// Based on: Steele, Lea and Flood 2014, Fast Splittable Pseudorandom Number Generators (SplitMix64)
#pragma once

#include <cstdint>

namespace lacquer::simulator {

class RandomStream {
 public:
    RandomStream(std::uint64_t seed, std::uint64_t walk)
        : state_{mix(mix(seed) ^ (walk * kStreamStep))} {}

    // Uniform in (0, 1): neither end, so that logarithms and reciprocals of it are finite.
    double uniform() {
        state_ += kStep;
        return (static_cast<double>(mix(state_) >> 12) + 0.5) * 0x1p-52;
    }

 private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;
    static constexpr std::uint64_t kStreamStep = 0xd1342543de82ef95u;

    static constexpr std::uint64_t mix(std::uint64_t x) {
        x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
        x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
        return x ^ (x >> 31);
    }

    std::uint64_t state_;
};

}  // namespace lacquer::simulator
