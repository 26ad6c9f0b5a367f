#include "heightfield/scattered_light.h"

#include <cmath>

#include "heightfield/heightfield.h"
#include "simulator/slice_picture.h"

namespace lacquer::heightfield {

namespace {

using simulator::RandomStream;
using simulator::RgbEstimate;
using simulator::RgbMoments;
using simulator::SlicePicture;
using simulator::SurfaceWalk;
using simulator::Vec3;

// Rays between two merges of tallies, which take time in proportion to their pixels.
constexpr std::uint64_t kBlock = 1 << 13;

// What the rays of one repetition carried, not yet divided by their number.
struct Tally {
    std::vector<Vec3> energies;             // per order
    std::vector<std::vector<Vec3>> pixels;  // per order
    Vec3 transmitted{0.0};
    double strays = 0.0;
    std::uint64_t count = 0;

    void grow(std::size_t orders, std::size_t pixel_count) {
        if (!energies.empty()) return;
        energies.resize(orders, Vec3{0.0});
        pixels.resize(orders, std::vector<Vec3>(pixel_count, Vec3{0.0}));
    }

    void merge(const Tally& other) {
        if (!other.energies.empty()) grow(other.energies.size(), other.pixels.front().size());
        for (std::size_t order = 0; order < other.energies.size(); ++order) {
            energies[order] += other.energies[order];
            for (std::size_t pixel = 0; pixel < pixels[order].size(); ++pixel)
                pixels[order][pixel] += other.pixels[order][pixel];
        }
        transmitted += other.transmitted;
        strays += other.strays;
    }
};

// `cross(direction, random)` sends one ray through a surface.
template <typename Cross>
Tally tally_rays(const Cross& cross, const Vec3& wi, std::uint64_t seed,
                 const LightOptions& options) {
    const SlicePicture picture{options.picture_size};
    const auto orders = static_cast<std::size_t>(options.orders) + 1;
    std::uint64_t reported = 0;
    const simulator::RunOptions run{options.rays, seed, [&](std::uint64_t done) {
                                        if (options.on_rays) options.on_rays(done - reported);
                                        reported = done;
                                        return true;
                                    }};
    return simulator::run_walks<Tally>(
        run,
        [&](RandomStream& random, Tally& tally) {
            const Trip trip = cross(-wi, random);
            tally.strays += trip.stray ? 1.0 : 0.0;
            if (trip.lost) return;
            if (trip.below) {
                tally.transmitted += trip.weight;
                return;
            }
            tally.grow(orders, picture.pixel_count());
            const std::size_t order = std::min(static_cast<std::size_t>(trip.order), orders) - 1;
            tally.energies[order] += trip.weight;
            tally.pixels[order][picture.pixel_of(trip.direction)] += trip.weight;
        },
        kBlock);
}

// Means over repetitions, of which each counts once.
class Repetitions {
 public:
    explicit Repetitions(const LightOptions& options)
        : picture_{options.picture_size},
          energies_(static_cast<std::size_t>(options.orders) + 1),
          pixels_(energies_.size(), std::vector<RgbMoments>(picture_.pixel_count())) {}

    void add(Tally tally) {
        tally.grow(energies_.size(), picture_.pixel_count());
        const double per_ray = 1.0 / static_cast<double>(tally.count);
        Vec3 all{0.0};
        for (std::size_t order = 0; order < energies_.size(); ++order) {
            energies_[order].add(tally.energies[order] * per_ray);
            all += tally.energies[order];
            for (std::size_t pixel = 0; pixel < pixels_[order].size(); ++pixel)
                pixels_[order][pixel].add(tally.pixels[order][pixel] *
                                          (per_ray / picture_.solid_angle()));
        }
        reflected_.add(all * per_ray);
        transmitted_.add(tally.transmitted * per_ray);
        strays_ += tally.strays * per_ray;
        ++count_;
    }

    ScatteredLight light() const {
        ScatteredLight light;
        for (std::size_t order = 0; order < energies_.size(); ++order) {
            OrderLight& one = light.orders.emplace_back();
            one.energy = estimate(energies_[order]);
            for (const RgbMoments& pixel : pixels_[order]) one.pixels.push_back(estimate(pixel));
        }
        light.reflected = estimate(reflected_);
        light.transmitted = estimate(transmitted_);
        light.strays = strays_ / count_;
        return light;
    }

 private:
    // Few repetitions spread about their own mean less than about the true one.
    RgbEstimate estimate(const RgbMoments& moments) const {
        RgbEstimate result = moments.estimate(count_);
        for (double& error : result.standard_error) error *= std::sqrt(count_ / (count_ - 1.0));
        return result;
    }

    SlicePicture picture_;
    std::vector<RgbMoments> energies_;
    std::vector<std::vector<RgbMoments>> pixels_;
    RgbMoments reflected_, transmitted_;
    double strays_ = 0.0;
    double count_ = 0.0;
};

// A seed for the rays of a repetition: another than that of its surface, and than other
// repetitions'.
std::uint64_t ray_seed(std::uint64_t seed, std::uint64_t repetition) {
    constexpr std::uint64_t kStep = 0xda942042e4dd58b5u;
    return seed + kStep * (repetition + 1);
}

std::vector<ScatteredLight> lights(const std::vector<Repetitions>& sums) {
    std::vector<ScatteredLight> result;
    for (const Repetitions& sum : sums) result.push_back(sum.light());
    return result;
}

}  // namespace

std::vector<ScatteredLight> heightfield_light(std::span<const simulator::FacetStratum> strata,
                                              std::span<const Vec3> wi, const FieldGrid& grid,
                                              const LightOptions& options) {
    std::vector<Repetitions> sums(wi.size(), Repetitions{options});
    for (std::uint64_t repetition = 0; repetition < options.repetitions; ++repetition) {
        const Heightfield surface{strata, grid, options.seed, repetition};
        const auto cross = [&surface](const Vec3& direction, RandomStream& random) {
            return surface.cross(direction, random);
        };
        for (std::size_t n = 0; n < wi.size(); ++n)
            sums[n].add(tally_rays(cross, wi[n], ray_seed(options.seed, repetition), options));
    }
    return lights(sums);
}

std::vector<ScatteredLight> smith_light(const SurfaceWalk& surface, std::span<const Vec3> wi,
                                        const LightOptions& options) {
    const auto cross = [&surface](const Vec3& direction, RandomStream& random) {
        return Trip{surface.cross(direction, random)};
    };
    std::vector<Repetitions> sums(wi.size(), Repetitions{options});
    for (std::uint64_t repetition = 0; repetition < options.repetitions; ++repetition)
        for (std::size_t n = 0; n < wi.size(); ++n)
            sums[n].add(tally_rays(cross, wi[n], ray_seed(options.seed, repetition), options));
    return lights(sums);
}

}  // namespace lacquer::heightfield
