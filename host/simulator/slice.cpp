#include "simulator/slice.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>

#include "simulator/next_event.h"

namespace lacquer::simulator {

namespace {

// The picture of a hemisphere in Lambert's azimuthal equal-area projection, cos_theta = 1 - r^2 on
// the unit disk.
class SlicePicture {
 public:
    explicit SlicePicture(int size) : size_{size} {}

    std::size_t pixel_count() const { return static_cast<std::size_t>(size_ * size_); }

    // Solid angle of a whole pixel.
    double solid_angle() const { return 8.0 / (static_cast<double>(size_) * size_); }

    // Position on the disk of a point of pixel `index`, (0.5, 0.5) its centre.
    glm::dvec2 position(std::size_t index, double x, double y) const {
        const auto column = static_cast<double>(index % static_cast<std::size_t>(size_));
        const auto row = static_cast<double>(index / static_cast<std::size_t>(size_));
        return {2.0 * (column + x) / size_ - 1.0, 1.0 - 2.0 * (row + y) / size_};
    }

    static double cosine(const glm::dvec2& p) { return 1.0 - p.x * p.x - p.y * p.y; }

    static Vec3 direction(const glm::dvec2& p) {
        const double scale = std::sqrt(1.0 + cosine(p));
        return {p.x * scale, p.y * scale, cosine(p)};
    }

    std::size_t pixel_of(const Vec3& w) const {
        const double scale = 1.0 / std::sqrt(1.0 + w.z);
        const int column = static_cast<int>(0.5 * (1.0 + w.x * scale) * size_);
        const int row = static_cast<int>(0.5 * (1.0 - w.y * scale) * size_);
        return static_cast<std::size_t>(std::clamp(row, 0, size_ - 1) * size_ +
                                        std::clamp(column, 0, size_ - 1));
    }

    // Integral of the cosine over the part of a pixel that is on the disk.
    double projected_solid_angle(std::size_t index) const {
        constexpr int kSteps = 16;
        double sum = 0.0;
        for (int j = 0; j < kSteps; ++j)
            for (int i = 0; i < kSteps; ++i)
                sum +=
                    std::max(0.0, cosine(position(index, (i + 0.5) / kSteps, (j + 0.5) / kSteps)));
        return solid_angle() * sum / (kSteps * kSteps);
    }

    // Pixels whose centre is on the disk.
    std::vector<std::size_t> visible_pixels() const {
        std::vector<std::size_t> visible;
        for (std::size_t index = 0; index < pixel_count(); ++index)
            if (cosine(position(index, 0.5, 0.5)) > 0.0) visible.push_back(index);
        return visible;
    }

 private:
    int size_;
};

struct SliceTally {
    std::vector<RgbMoments> pixels;  // empty as long as no light came
    std::uint64_t count = 0;

    void merge(const SliceTally& other) {
        if (pixels.empty()) pixels.resize(other.pixels.size());
        for (std::size_t index = 0; index < other.pixels.size(); ++index)
            pixels[index].merge(other.pixels[index]);
    }

    RgbMoments& pixel(const SlicePicture& picture, std::size_t index) {
        if (pixels.empty()) pixels.resize(picture.pixel_count());
        return pixels[index];
    }
};

// Walks between two merges of tallies, which take time in proportion to their pixels.
std::uint64_t block_of(const SlicePicture& picture) {
    constexpr std::uint64_t kMinBlock = 1 << 14;
    return std::max(kMinBlock, std::uint64_t{picture.pixel_count()});
}

SliceEstimate by_histogram(const StackWalk& stack, const Vec3& wo, const SlicePicture& picture,
                           const RunOptions& options) {
    SliceTally tally = run_walks<SliceTally>(
        options,
        [&](RandomStream& random, SliceTally& sum) {
            const Exit exit = stack.walk(wo, random);
            if (exit.fate == Fate::direct || exit.fate == Fate::base)
                sum.pixel(picture, picture.pixel_of(exit.direction)).add(exit.weight);
        },
        block_of(picture));
    tally.pixels.resize(picture.pixel_count());
    SliceEstimate result{SliceMethod::histogram, {}, tally.count};
    result.pixels.resize(picture.pixel_count());
    for (const std::size_t index : picture.visible_pixels())
        result.pixels[index] = tally.pixels[index].estimate(
            static_cast<double>(tally.count), 1.0 / picture.projected_solid_angle(index));
    return result;
}

SliceEstimate by_next_event(const SurfaceWalk& surface, int max_order, const Vec3& wo,
                            const SlicePicture& picture, const RunOptions& options) {
    // Walk after walk serves pixel after pixel, so that a stopped run has seen all of them.
    const std::vector<std::size_t> visible = picture.visible_pixels();
    struct CountingTally : SliceTally {
        std::vector<std::uint64_t> walks;

        void merge(const CountingTally& other) {
            SliceTally::merge(other);
            if (walks.empty()) walks.resize(other.walks.size());
            for (std::size_t index = 0; index < other.walks.size(); ++index)
                walks[index] += other.walks[index];
        }
    };
    CountingTally tally = run_walks<CountingTally>(
        options,
        [&](RandomStream& random, CountingTally& sum, std::uint64_t n) {
            const std::size_t index = visible[n % visible.size()];
            const Vec3 wi = SlicePicture::direction(picture.position(index, 0.5, 0.5));
            sum.pixel(picture, index)
                .add(next_event_density(surface, wi, wo, random, max_order) / wi.z);
            if (sum.walks.empty()) sum.walks.resize(picture.pixel_count());
            ++sum.walks[index];
        },
        block_of(picture));
    SliceEstimate result{SliceMethod::next_event, {}, tally.count};
    result.pixels.resize(picture.pixel_count());
    for (const std::size_t index : visible)
        if (!tally.walks.empty() && tally.walks[index] > 0)
            result.pixels[index] =
                tally.pixels[index].estimate(static_cast<double>(tally.walks[index]));
    return result;
}

}  // namespace

SliceEstimate estimate_slice(const StackWalk& stack, const Vec3& wo, int size,
                             const RunOptions& options) {
    const SlicePicture picture{size};
    const SurfaceWalk* surface = stack.only_surface();
    if (surface != nullptr && has_density(*surface))
        return by_next_event(*surface, stack.orders_per_crossing(), wo, picture, options);
    return by_histogram(stack, wo, picture, options);
}

}  // namespace lacquer::simulator
