#include "simulator/slice.h"

#include <algorithm>

#include "simulator/next_event.h"
#include "simulator/slice_picture.h"

namespace lacquer::simulator {

namespace {

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
