// The model `stack` of the reference against the simulator: albedos and widths of lobes, on random
// stacks and directions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

#include "reference/facets.h"
#include "reference/stack/stack.h"
#include "simulator/goniophotometer.h"
#include "stack_errors.h"
#include "stack_random.h"

namespace lacquer {
namespace {

using test::BaseKind;
using test::Configuration;
using test::direction;
using test::Errors;
using test::random_configuration;
using test::uniform;
using test::uniform_rgb;

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

// Most media then scatter, up to three times along the normal on average.
void make_cloudy(std::mt19937_64& generator, Configuration& at) {
    for (Layer& layer : at.material.layers) {
        if (uniform(generator, 0.0, 1.0) < 0.3) continue;
        const double scattering = uniform(generator, 0.0, 3.0);
        layer.medium = ScatteringMedium{uniform_rgb(generator, 0.0, 0.5),
                                        {scattering, scattering, scattering},
                                        uniform(generator, 0.0, 0.95),
                                        1.0};
    }
}

Errors albedo_errors(BaseKind base, int coats, int configurations, std::uint64_t walks,
                     bool cloudy = false) {
    std::mt19937_64 generator{20180812u + static_cast<unsigned>(coats)};
    Errors errors;
    for (int n = 0; n < configurations; ++n) {
        Configuration at = random_configuration(generator, base, coats);
        if (cloudy) make_cloudy(generator, at);
        const glm::dvec3 wo = direction(at.cos_theta);
        const auto truth =
            simulator::estimate_distribution(simulator::StackWalk{at.material}, wo, {1, 1},
                                             {walks, static_cast<std::uint64_t>(n) + 1, {}});
        const auto surface = reference::prepare_stack(at.material, tables());
        const reference::Albedo model = reference::albedo(surface, wo);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int c = static_cast<int>(channel);
            const double simulated =
                truth.direct.energy.mean[channel] + truth.base.energy.mean[channel];
            const double noise = std::hypot(truth.direct.energy.standard_error[channel],
                                            truth.base.energy.standard_error[channel]);
            errors.add(model.direct[c] + model.base[c] - simulated, noise, describe(at, channel));
        }
    }
    errors.print(fmt::format("{}, {} coats",
                             base == BaseKind::lambertian ? "lambertian" : "conductor", coats));
    return errors;
}

// What the model promises of the total albedo, in the mean over stacks of as many coats.
constexpr double kMeanAlbedoError = 0.006;
// The largest error of 1160 stacks, rounded up (measured: 0.070). Rough coats seen at grazing
// angles have it, whose light arrives below just about the critical angle of its way back.
constexpr double kMaxAlbedoError = 0.075;

// Noise widens |errors| on average by no more than its standard error, and by more than five times
// that never.
constexpr double kSureNoises = 5.0;

void expect_albedos(BaseKind base, int configurations, std::uint64_t walks) {
    for (int coats = 1; coats <= 4; ++coats) {
        const Errors errors = albedo_errors(base, coats, configurations, walks);
        EXPECT_LE(errors.mean(), kMeanAlbedoError + errors.noise()) << coats << " coats";
        EXPECT_LE(errors.worst(), kMaxAlbedoError + kSureNoises * errors.noise())
            << coats << " coats";
    }
}

TEST(StackSimulation, AlbedoOverLambertianBases) {
    expect_albedos(BaseKind::lambertian, 12, 50'000);
}

TEST(StackSimulation, AlbedoOverConductors) {
    expect_albedos(BaseKind::conductor, 24, 50'000);
}

// Over both bases, in the mean over stacks of as many coats (measured: 0.005 to 0.010), and the
// largest (measured: 0.040).
TEST(StackSimulation, AlbedoWithScatteringMedia) {
    constexpr double kMeanCloudyError = 0.012, kMaxCloudyError = 0.06;
    for (const BaseKind base : {BaseKind::lambertian, BaseKind::conductor})
        for (int coats = 1; coats <= 2; ++coats) {
            const Errors errors = albedo_errors(base, coats, 12, 20'000, true);
            EXPECT_LE(errors.mean(), kMeanCloudyError + errors.noise()) << coats << " coats";
            EXPECT_LE(errors.worst(), kMaxCloudyError + kSureNoises * errors.noise())
                << coats << " coats";
        }
}

// Root mean square distance from the mean, per axis of the projected disk, of light that a stack's
// lobe reflects.
double width_of(const reference::StackLobe& lobe, const glm::dvec3& wo) {
    constexpr int kSteps = 64;
    const reference::Facets facets{Ndf::ggx, lobe.alpha, lobe.alpha};
    double light = 0.0, x = 0.0, square = 0.0;
    for (int n = 0; n < kSteps * kSteps; ++n) {
        const glm::dvec2 u{(n % kSteps + 0.5) / kSteps, (n / kSteps + 0.5) / kSteps};
        const glm::dvec3 wm = reference::sample_visible_normal(facets, wo, u);
        const glm::dvec3 wi = 2.0 * glm::dot(wo, wm) * wm - wo;
        if (wi.z <= 0.0) continue;
        const double seen = reference::masking_shadowing(facets, wi, wo);
        light += seen;
        x += seen * wi.x;
        square += seen * (wi.x * wi.x + wi.y * wi.y);
    }
    return std::sqrt(0.5 * (square / light - x * x / (light * light)));
}

// That the light of a conductor comes back as wide as it should, for alpha up to 0.5. Not always:
// below a rough coat seen at grazing angles it is up to 1.3 times too wide.
void expect_widths(int configurations, std::uint64_t walks) {
    constexpr double kWidthError = 0.1;
    constexpr double kShareWithin = 0.75;  // measured: 0.86 of stacks
    constexpr double kLeastLight = 0.01;   // whose width the simulator knows
    std::mt19937_64 generator{20180813u};
    Errors errors;
    int within = 0, all = 0;
    for (int n = 0; n < configurations; ++n) {
        const Configuration at = random_configuration(generator, BaseKind::conductor, 1, 0.5);
        const glm::dvec3 wo = direction(at.cos_theta);
        const auto truth =
            simulator::estimate_distribution(simulator::StackWalk{at.material}, wo, {1, 1},
                                             {walks, static_cast<std::uint64_t>(n) + 1, {}});
        if (truth.base.energy.mean[0] < kLeastLight) continue;
        const double simulated =
            std::sqrt(0.5 * (truth.base.variance_x.mean[0] + truth.base.variance_y.mean[0]));
        const auto surface = reference::prepare_stack(at.material, tables());
        const double width = width_of(reference::view(surface, wo).lobes.back(), wo);
        const double error = width / simulated - 1.0;
        errors.add(error, 0.0, describe(at, 0));
        ++all;
        if (std::abs(error) <= kWidthError) ++within;
    }
    errors.print("width, relative, 1 coat");
    fmt::print("within {:.0f} %: {} of {}\n", 100.0 * kWidthError, within, all);
    EXPECT_GE(within, kShareWithin * all);
}

TEST(StackSimulation, WidthOverConductors) {
    expect_widths(48, 50'000);
}

TEST(StackSimulationFull, WidthOverManyConductors) {
    expect_widths(400, 100'000);
}

TEST(StackSimulationFull, AlbedoOverManyLambertianBases) {
    expect_albedos(BaseKind::lambertian, 300, 100'000);
}

TEST(StackSimulationFull, AlbedoOverManyConductors) {
    expect_albedos(BaseKind::conductor, 300, 100'000);
}

}  // namespace
}  // namespace lacquer
