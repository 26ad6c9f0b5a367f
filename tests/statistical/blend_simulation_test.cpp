// Stacks and coats whose interfaces are blends, in the reference, against the simulator: total
// albedos on random materials and directions.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "reference/coated.h"
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

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

Configuration random_blends(std::mt19937_64& generator, BaseKind base, int coats) {
    Configuration at = test::random_configuration(generator, base, coats);
    test::make_blended(generator, at);
    return at;
}

glm::dvec3 all_light(const reference::Albedo& albedo) {
    return albedo.direct + albedo.base;
}

// Of `model(material)`, all light that is reflected or, of an interface without a base, let
// through.
template <typename Model>
Errors albedo_errors(const std::string& name, BaseKind base, int coats, int configurations,
                     std::uint64_t walks, const Model& model) {
    std::mt19937_64 generator{20261124u + static_cast<unsigned>(coats)};
    Errors errors;
    for (int n = 0; n < configurations; ++n) {
        const Configuration at = random_blends(generator, base, coats);
        const glm::dvec3 wo = direction(at.cos_theta);
        const auto truth =
            simulator::estimate_distribution(simulator::StackWalk{at.material}, wo, {1, 1},
                                             {walks, static_cast<std::uint64_t>(n) + 1, {}});
        const glm::dvec3 light = model(at.material, wo);
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double simulated =
                truth.direct.energy.mean[channel] + truth.base.energy.mean[channel];
            const double noise = std::hypot(truth.direct.energy.standard_error[channel],
                                            truth.base.energy.standard_error[channel]);
            errors.add(light[static_cast<int>(channel)] - simulated, noise, describe(at, channel));
        }
    }
    errors.print(name);
    return errors;
}

// What is promised of the mean. Measured: 0.0022 of coats, 0.0034 to 0.0068 of stacks.
constexpr double kMeanAlbedoError = 0.01;

// Noise widens |errors| on average by no more than its standard error.
template <reference::StackLobes lobes>
void expect_stacks(BaseKind base, int configurations, std::uint64_t walks) {
    const auto model = [](const Material& material, const glm::dvec3& wo) {
        return all_light(
            reference::albedo(reference::prepare_stack(material, tables(), lobes), wo));
    };
    for (int coats = 1; coats <= 3; ++coats) {
        const Errors errors = albedo_errors(fmt::format("{} coats", coats), base, coats,
                                            configurations, walks, model);
        EXPECT_LE(errors.mean(), kMeanAlbedoError + errors.noise()) << coats << " coats";
    }
}

void expect_coats(int configurations, std::uint64_t walks) {
    const Errors errors = albedo_errors(
        "coated", BaseKind::lambertian, 1, configurations, walks,
        [](const Material& material, const glm::dvec3& wo) {
            return all_light(reference::albedo(
                reference::prepare_coated(material, tables(), reference::BaseLobe::exact), wo));
        });
    EXPECT_LE(errors.mean(), kMeanAlbedoError + errors.noise());
}

TEST(BlendSimulation, StacksOverLambertianBases) {
    expect_stacks<reference::StackLobes::forward>(BaseKind::lambertian, 12, 50'000);
}

TEST(BlendSimulation, StacksOverBlendedConductors) {
    expect_stacks<reference::StackLobes::forward>(BaseKind::conductor, 24, 50'000);
}

TEST(BlendSimulation, SymmetricStacks) {
    expect_stacks<reference::StackLobes::symmetric>(BaseKind::conductor, 12, 50'000);
}

TEST(BlendSimulation, Coats) {
    expect_coats(24, 50'000);
}

TEST(BlendSimulationFull, ManyStacksOverLambertianBases) {
    expect_stacks<reference::StackLobes::forward>(BaseKind::lambertian, 150, 100'000);
}

TEST(BlendSimulationFull, ManyStacksOverBlendedConductors) {
    expect_stacks<reference::StackLobes::forward>(BaseKind::conductor, 150, 100'000);
}

TEST(BlendSimulationFull, ManyCoats) {
    expect_coats(400, 100'000);
}

// The lobe of a coat has the light that its energies say, whatever the strata: measured by
// sampling. Blends lack up to this, what one stratum takes of another's reflections.
TEST(BlendSimulationFull, LobesOfCoatsHaveTheirAlbedo) {
    std::mt19937_64 generator{20261125u};
    Errors errors;
    for (int n = 0; n < 200; ++n) {
        const Configuration at = random_blends(generator, BaseKind::none, 1);
        const Interface& interface = at.material.layers.front().interface;
        const auto coat = reference::prepare_coat(interface.roughness, interface.ior, tables());
        const glm::dvec3 wo = direction(at.cos_theta);
        double sum = 0.0;
        constexpr int kPoints = 20'000;
        std::uniform_real_distribution<double> next(0.0, 1.0);
        for (int point = 0; point < kPoints; ++point) {
            const double choice = next(generator), u = next(generator), v = next(generator);
            const glm::dvec3 wi = reference::coat_sample(coat, wo, choice, {u, v});
            if (wi.z <= 0.0) continue;
            sum += reference::coat_lobe(coat, wi, wo) * wi.z / reference::coat_pdf(coat, wi, wo);
        }
        errors.add(sum / kPoints - reference::coat_albedo(coat, wo), 0.0, describe(at, 0));
    }
    errors.print("lobes of coats");
    EXPECT_LE(errors.mean(), kMeanAlbedoError);
}

}  // namespace
}  // namespace lacquer
