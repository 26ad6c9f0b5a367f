// The model `microsurface-stochastic` of the reference against the simulator: means over seeds of
// light of all orders, by z tests.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reference/microsurface/microsurface_stochastic.h"
#include "simulator/goniophotometer.h"
#include "simulator/next_event.h"
#include "support/random_microsurfaces.h"

namespace lacquer {
namespace {

using reference::StochasticMicrosurface;
using simulator::StackWalk;

// Standard errors that a mean of so many values is off by no more than once in 16,000 times.
constexpr double kErrors = 4.0;

// Of f: light that a walk from one end, as the simulator's, finds so rarely that its standard error
// is a guess. Weaker light is not tested here.
constexpr double kRareLight = 1e-4;

// Mean and variance of values as they come.
struct Moments {
    double count = 0.0, sum = 0.0, squares = 0.0;

    void add(double value) {
        count += 1.0;
        sum += value;
        squares += value * value;
    }
    double mean() const { return sum / count; }
    double variance() const { return std::max(squares / count - mean() * mean(), 0.0); }
    double squared_error() const { return variance() / count; }
};

glm::dvec3 random_direction(std::mt19937_64& generator, bool both_sides) {
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    const double cosine = 0.05 + 0.95 * uniform(generator);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double phi = 2.0 * std::numbers::pi * uniform(generator);
    const double side = both_sides && uniform(generator) < 0.4 ? -1.0 : 1.0;
    return {sine * std::cos(phi), sine * std::sin(phi), side * cosine};
}

Material random_material(std::mt19937_64& generator, int n, double least_alpha) {
    const int strata = 1 + n / 2 % 3;
    return n % 2 == 1 ? test::random_dielectric(generator, strata, least_alpha)
                      : test::random_conductor(generator, strata, least_alpha);
}

void expect_means(int surfaces, std::uint32_t seeds) {
    std::mt19937_64 generator{20230901};
    for (int n = 0; n < surfaces; ++n) {
        const Material material = random_material(generator, n, 0.1);
        const glm::dvec3 wo = random_direction(generator, n % 2 == 1);
        const glm::dvec3 wi = random_direction(generator, n % 2 == 1);
        const StochasticMicrosurface surface = reference::prepare_microsurface_stochastic(material);
        const StackWalk stack{material};
        const simulator::SurfaceWalk& walk = *stack.only_surface();
        Moments model, truth;
        for (std::uint32_t seed = 0; seed < seeds; ++seed) {
            model.add(eval(surface, wi, wo, seed).x);
            simulator::RandomStream random{static_cast<std::uint64_t>(n), seed};
            truth.add(next_event_density(walk, wi, wo, random).x / std::abs(wi.z));
        }
        EXPECT_NEAR(model.mean(), truth.mean(),
                    kErrors * std::sqrt(model.squared_error() + truth.squared_error()) + kRareLight)
            << test::describe(material)
            << fmt::format(" wi ({:.3f}, {:.3f}, {:.3f}) wo ({:.3f}, {:.3f}, {:.3f})", wi.x, wi.y,
                           wi.z, wo.x, wo.y, wo.z);
    }
}

TEST(MicrosurfaceStochasticSimulation, MeansOfEval) {
    expect_means(32, 1u << 15);
}

TEST(MicrosurfaceStochasticSimulationFull, MeansOfEvalOfManySurfaces) {
    expect_means(200, 1u << 16);
}

TEST(MicrosurfaceStochasticSimulation, Albedos) {
    constexpr std::uint64_t kWalks = 100'000;
    std::mt19937_64 generator{20230902};
    for (int n = 0; n < 4; ++n) {
        const Material material = random_material(generator, n, 0.02);
        const glm::dvec3 wo = random_direction(generator, n % 2 == 1);
        const StackWalk stack{material};
        const simulator::RunOptions options{kWalks, static_cast<std::uint64_t>(n) + 1, {}};
        const auto truth = wo.z > 0.0
                               ? estimate_distribution(stack, wo, {1, 1}, options)
                               : estimate_distribution_from_below(stack, wo, {1, 1}, options);
        const auto light = albedo(reference::prepare_microsurface_stochastic(material), wo, 7u);
        // An albedo in [0, 1] estimated by n walks of weights up to 1.
        const double own_error = 0.5 / std::sqrt(static_cast<double>(reference::kAlbedoWalks));
        const auto expect = [&](const glm::dvec3& value, const simulator::RgbEstimate& expected) {
            EXPECT_NEAR(value.x, expected.mean[0],
                        kErrors * std::hypot(expected.standard_error[0], own_error))
                << test::describe(material) << " from " << wo.z;
        };
        expect(light.base, truth.base.energy);
        expect(wo.z > 0.0 ? light.direct : light.transmitted, truth.direct.energy);
        expect(wo.z > 0.0 ? light.transmitted : light.direct, truth.transmitted.energy);
    }
}

// Paths of both ends are worth their variance: on average over surfaces it is well below that of
// walks from the viewer alone, which the simulator makes, of the light that met several facets.
TEST(MicrosurfaceStochasticSimulation, VariesLessThanWalksFromOneEnd) {
    std::mt19937_64 generator{20230903};
    double logarithms = 0.0;
    constexpr int kSurfaces = 16;
    for (int n = 0; n < kSurfaces; ++n) {
        const Material material = random_material(generator, n, 0.1);
        const glm::dvec3 wo = random_direction(generator, false);
        const glm::dvec3 wi = random_direction(generator, false);
        const StochasticMicrosurface surface = reference::prepare_microsurface_stochastic(material);
        const StackWalk stack{material};
        Moments model, one_end;
        for (std::uint32_t seed = 0; seed < 2048; ++seed) {
            model.add(eval(surface, wi, wo, seed).x);
            simulator::RandomStream all{static_cast<std::uint64_t>(n), seed};
            simulator::RandomStream once{static_cast<std::uint64_t>(n), seed};
            const double scale = 1.0 / wi.z;
            one_end.add(scale * (next_event_density(*stack.only_surface(), wi, wo, all).x -
                                 next_event_density(*stack.only_surface(), wi, wo, once, 1).x));
        }
        logarithms += std::log(one_end.variance() / model.variance());
    }
    const double ratio = std::exp(logarithms / kSurfaces);
    RecordProperty("variance_ratio", fmt::format("{:.2f}", ratio));
    EXPECT_GT(ratio, 2.0);  // two walks of the same kind would give 2
}

}  // namespace
}  // namespace lacquer
