// The model `microsurface-single` of the reference against light that meets one facet in the
// simulator: albedos by z tests, and where the light goes by chi-square.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "reference/microsurface/microsurface_single.h"
#include "simulator/goniophotometer.h"
#include "simulator/stack.h"
#include "support/chi_square.h"
#include "support/expect_fit.h"
#include "support/random_microsurfaces.h"

namespace lacquer {
namespace {

using reference::SingleMicrosurface;
using simulator::Distribution;
using simulator::GoniophotometerEstimate;
using simulator::HemisphereGrid;
using simulator::StackWalk;

// One facet at most.
constexpr simulator::StackOptions kSingle{1};

// Standard errors that a mean of so many walks is off by no more than once in 16,000 times, and
// light so rare that its standard error is a guess.
constexpr double kErrors = 4.0;
constexpr double kRareLight = 1e-6;

struct Configuration {
    Material material;
    glm::dvec3 wo;  // to either side of a dielectric
};

Configuration random_configuration(std::mt19937_64& generator, int n, double least_alpha) {
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    const int strata = 1 + n % 3;
    const bool refracts = n % 2 == 1;
    Configuration at{refracts ? test::random_dielectric(generator, strata, least_alpha)
                              : test::random_conductor(generator, strata, least_alpha),
                     {}};
    // Light that is near grazing meets several facets.
    const double cosine = 0.02 + 0.98 * uniform(generator);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double phi = 2.0 * std::numbers::pi * uniform(generator);
    const double side = refracts && uniform(generator) < 0.4 ? -1.0 : 1.0;
    at.wo = {sine * std::cos(phi), sine * std::sin(phi), side * cosine};
    return at;
}

std::string describe(const Configuration& at) {
    return fmt::format("{} from ({:.4f}, {:.4f}, {:.4f})", test::describe(at.material), at.wo.x,
                       at.wo.y, at.wo.z);
}

GoniophotometerEstimate simulated(const Configuration& at, const HemisphereGrid& grid,
                                  std::uint64_t walks, std::uint64_t seed) {
    const StackWalk stack{at.material, kSingle};
    return at.wo.z > 0.0 ? estimate_distribution(stack, at.wo, grid, {walks, seed, {}})
                         : estimate_distribution_from_below(stack, at.wo, grid, {walks, seed, {}});
}

void expect_albedo(const glm::dvec3& value, const simulator::RgbEstimate& truth,
                   const std::string& what) {
    for (std::size_t c = 0; c < 3; ++c) {
        const double expected = truth.mean[c];
        EXPECT_NEAR(value[static_cast<int>(c)], expected,
                    kErrors * truth.standard_error[c] + kRareLight)
            << what;
    }
}

void expect_albedos(int configurations, std::uint64_t walks) {
    std::mt19937_64 generator{20230806};
    for (int n = 0; n < configurations; ++n) {
        const Configuration at = random_configuration(generator, n, 0.01);
        const auto truth = simulated(at, {1, 1}, walks, static_cast<std::uint64_t>(n) + 1);
        const auto surface = reference::prepare_microsurface_single(at.material);
        const reference::Albedo light = albedo(surface, at.wo);
        expect_albedo(light.base, truth.base.energy, describe(at));
        // The simulator's are the upper and the lower side, whichever the light comes from.
        const auto [up, down] = at.wo.z > 0.0 ? std::pair{light.direct, light.transmitted}
                                              : std::pair{light.transmitted, light.direct};
        expect_albedo(up, truth.direct.energy, describe(at) + ", upwards");
        expect_albedo(down, truth.transmitted.energy, describe(at) + ", downwards");
    }
}

TEST(MicrosurfaceSimulation, Albedos) {
    expect_albedos(24, 100'000);
}

TEST(MicrosurfaceSimulationFull, AlbedosOfTenMillionWalks) {
    expect_albedos(60, 10'000'000);
}

// What `density` sends to each cell of the hemisphere on the side of `side`, by the midpoint rule.
std::vector<double> expected_cells(const std::function<double(const glm::dvec3& wi)>& density,
                                   const HemisphereGrid& grid, double side) {
    constexpr int kSteps = 16;
    std::vector<double> cells;
    const double angle = 2.0 * std::numbers::pi / (grid.rows * grid.columns * kSteps * kSteps);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            double sum = 0.0;
            for (int j = 0; j < kSteps; ++j)
                for (int i = 0; i < kSteps; ++i) {
                    const double z = (row + (j + 0.5) / kSteps) / grid.rows;
                    const double phi =
                        2.0 * std::numbers::pi * (column + (i + 0.5) / kSteps) / grid.columns;
                    const double r = std::sqrt(1.0 - z * z);
                    sum += density({r * std::cos(phi), r * std::sin(phi), side * z});
                }
            cells.push_back(sum * angle);
        }
    return cells;
}

// Counts of light that left to one side, where it carries 1 or nothing, and last all other walks.
void expect_cells(const Distribution& truth, std::vector<double> expected, double walks,
                  double significance, const std::string& what) {
    std::vector<double> observed;
    double seen = 0.0, foreseen = 0.0;
    for (std::size_t cell = 0; cell < expected.size(); ++cell) {
        observed.push_back(walks * truth.cells[cell].mean[0]);
        expected[cell] *= walks;
        seen += observed.back();
        foreseen += expected[cell];
    }
    observed.push_back(walks - seen);
    expected.push_back(walks - foreseen);
    test::expect_fit(observed, expected, significance, what);
}

void expect_distributions(int configurations, std::uint64_t walks) {
    const HemisphereGrid grid{16, 32};
    const double significance = test::sidak_significance(0.01, 2 * configurations);
    std::mt19937_64 generator{20230810};
    for (int n = 0; n < configurations; ++n) {
        Configuration at = random_configuration(generator, 2 * (n / 2) + 1, 0.5);
        // Facets that reflect all light or refract it, so that walks can be counted; with lobes
        // wide enough for the midpoint rule.
        if (n % 2 == 0)
            at = {test::mirrors(at.material), {at.wo.x, at.wo.y, std::abs(at.wo.z)}};
        else
            at.material.layers.front().interface.ior = n % 4 == 1 ? 1.8 : 0.6;
        const auto truth = simulated(at, grid, walks, static_cast<std::uint64_t>(n) + 1);
        const SingleMicrosurface surface = reference::prepare_microsurface_single(at.material);
        const auto density = [&](const glm::dvec3& wi) {
            return eval(surface, wi, at.wo).x * std::abs(wi.z);
        };
        const auto expect = [&](const Distribution& light, double towards) {
            expect_cells(light, expected_cells(density, grid, towards), static_cast<double>(walks),
                         significance,
                         describe(at) + (towards > 0.0 ? ", upwards" : ", downwards"));
        };
        expect(surface.below ? truth.direct : truth.base, 1.0);
        if (surface.below) expect(truth.transmitted, -1.0);
    }
}

TEST(MicrosurfaceSimulation, Distributions) {
    expect_distributions(12, 200'000);
}

TEST(MicrosurfaceSimulationFull, ManyDistributions) {
    expect_distributions(100, 1'000'000);
}

}  // namespace
}  // namespace lacquer
