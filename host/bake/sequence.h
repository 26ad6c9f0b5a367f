// Numbers that drive a walk: low-discrepancy ones where a walk begins, hashed ones after that.
// Based on: Joe and Kuo 2008, Constructing Sobol Sequences with Better Two-Dimensional Projections
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace lacquer::bake {

// The first points of a Sobol sequence, shared by all nodes of a table.
class SobolPoints {
 public:
    static constexpr std::size_t kDimensions = 8;
    using Point = std::array<std::uint32_t, kDimensions>;

    explicit SobolPoints(std::size_t count);

    std::size_t count() const { return points_.size(); }
    const Point& operator[](std::size_t index) const { return points_[index]; }

 private:
    std::vector<Point> points_;
};

constexpr std::uint64_t mix_bits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

// The numbers in (0, 1) of one walk of one node: Sobol's point with its digits flipped by the
// node's own pattern, which keeps the points even and the noise of nodes independent.
class WalkNumbers {
 public:
    WalkNumbers(const SobolPoints& points, std::uint64_t node_seed, std::size_t walk)
        : point_{points[walk]},
          node_seed_{node_seed},
          state_{mix_bits(node_seed ^ mix_bits(walk + kStep))} {}

    double next() {
        if (dimension_ == SobolPoints::kDimensions) return hashed();
        const auto flips =
            static_cast<std::uint32_t>(mix_bits(node_seed_ + kStep * (dimension_ + 1)) >> 32);
        return (static_cast<double>(point_[dimension_++] ^ flips) + 0.5) * 0x1p-32;
    }

    // A number that uses up no dimension of the sequence.
    double hashed() {
        state_ += kStep;
        return (static_cast<double>(mix_bits(state_) >> 12) + 0.5) * 0x1p-52;
    }

 private:
    static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;

    const SobolPoints::Point& point_;
    std::uint64_t node_seed_, state_;
    std::size_t dimension_ = 0;
};

}  // namespace lacquer::bake
