// The simulated pictures of coats, which count the base's light in rings and estimate the coat's by
// next events, against walks that are counted where they end.
#include "study/coat_light.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "simulator/albedo.h"
#include "simulator/slice.h"

namespace lacquer::study {
namespace {

constexpr double kSigmas = 4.5;         // of 3 x 8 sums: two-sided 2e-4 with Sidak's correction
constexpr double kInterpolated = 0.01;  // share of a sum that lines between rings are off by
constexpr double kRingError = 0.01;     // of the rings together, from so many walks
constexpr int kSectors = 8;             // of azimuth
constexpr std::uint64_t kWalks = 1 << 19;

Material glaze(double eta, double alpha) {
    Material material;
    material.name = "glaze";
    material.layers.push_back(
        {{eta, Microsurface{Ndf::ggx, {alpha, alpha}}}, AbsorbingMedium{{1.0, 0.7, 0.4}}});
    material.base = LambertianBase{{0.9, 0.9, 0.5}};
    return material;
}

struct Sum {
    double value = 0.0, variance = 0.0;
};

using Sectors = std::array<std::array<Sum, 3>, kSectors>;

void add(Sectors& sectors, const glm::vec3& wi, std::size_t channel, double value, double error) {
    const double turn = std::atan2(double{wi.y}, double{wi.x}) / (2.0 * std::numbers::pi) + 0.5;
    Sum& sum =
        sectors[std::min(static_cast<std::size_t>(turn * kSectors), kSectors - 1ul)][channel];
    sum.value += value;
    sum.variance += error * error;
}

TEST(CoatLight, PicturesAgreeWithWalksCountedPerPixel) {
    for (const auto& [eta, alpha] : {std::pair{0.8, 0.3}, {1.5, 0.2}}) {
        const Material material = glaze(eta, alpha);
        const View view = slice_view(45.0);
        StudyRun run;
        run.samples = kWalks;
        const Radiance radiance = simulate(view, material, run);
        const glm::dvec3 wo = glm::dvec3{query_of(view.grid, 0).wo};
        const auto counted = simulator::estimate_slice(simulator::StackWalk{material}, wo,
                                                       view.grid.width, {kWalks, 99, {}});
        ASSERT_EQ(counted.method, simulator::SliceMethod::histogram);
        Sectors pictures, walks;
        for (std::size_t i = 0; i < radiance.values.size(); ++i) {
            const glm::vec3 wi = query_of(view.grid, i).wi;
            const auto& pixel = counted.pixels[view.grid.pixels[i]];
            for (std::size_t c = 0; c < 3; ++c) {
                const int channel = static_cast<int>(c);
                add(pictures, wi, c, radiance.values[i][channel], radiance.errors[i][channel]);
                const double scale = std::numbers::pi * wi.z;
                add(walks, wi, c, scale * pixel.mean[c], scale * pixel.standard_error[c]);
            }
        }
        for (std::size_t sector = 0; sector < kSectors; ++sector)
            for (std::size_t c = 0; c < 3; ++c) {
                const Sum &a = pictures[sector][c], &b = walks[sector][c];
                // Pixels share their rings: their errors add up, not their variances.
                const double rings = kRingError * a.value;
                EXPECT_NEAR(
                    a.value, b.value,
                    kSigmas * std::sqrt(a.variance + b.variance) + rings + kInterpolated * b.value)
                    << "eta " << eta << ", sector " << sector << ", channel " << c;
            }
    }
}

// Lit from behind, a sphere shows its sky alone.
TEST(CoatLight, SkyLightOfASphereIsItsAlbedo) {
    constexpr double kBetweenViewers = 2e-3;  // lines instead of the albedo's bends, 1/64 apart
    const Material material = glaze(1.5, 0.2);
    const View view{"back", "back", sphere_grid("back", {0.0, 0.0, -1.0}, 16), 1.0};
    StudyRun run;
    run.samples = kWalks;
    const Radiance radiance = simulate(view, material, run);
    const simulator::StackWalk stack{material};
    for (std::size_t i = 0; i < radiance.values.size(); i += 37) {
        const double cos_theta_o = query_of(view.grid, i).wo.z;
        const auto albedo = simulator::estimate_albedo(stack, cos_theta_o, {kWalks / 8, i, {}});
        for (std::size_t c = 0; c < 3; ++c) {
            const int channel = static_cast<int>(c);
            EXPECT_NEAR(radiance.values[i][channel], albedo.total.mean[c],
                        kBetweenViewers + kSigmas * std::hypot(radiance.errors[i][channel],
                                                               albedo.total.standard_error[c]))
                << "cos_theta_o " << cos_theta_o << ", channel " << c;
        }
    }
}

TEST(CoatLight, KeepsItsNumbersWhateverElseIsSimulated) {
    const View view = slice_view(30.0);
    StudyRun run;
    run.samples = 4096;
    const Material material = glaze(1.5, 0.3);
    const Radiance first = simulate(view, material, run);
    simulate(view, glaze(0.8, 0.3), run);
    const Radiance again = simulate(view, material, run);
    EXPECT_EQ(first.values, again.values);
    run.seed = 2;
    EXPECT_NE(simulate(view, material, run).values, first.values);
}

TEST(CoatLight, RefusesASmoothCoat) {
    StudyRun run;
    run.samples = 1;
    EXPECT_ANY_THROW(simulate(slice_view(30.0), glaze(1.5, 0.0), run));
}

}  // namespace
}  // namespace lacquer::study
