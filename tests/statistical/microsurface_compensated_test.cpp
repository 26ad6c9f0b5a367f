// The model `microsurface-compensated` of the reference against walks of all orders: how far its
// albedos are off over random surfaces. The bounds keep what the model was measured to be worth,
// which from the denser side of anisotropic interfaces is not much; README has the figures.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "reference/microsurface/microsurface_compensated.h"
#include "simulator/goniophotometer.h"
#include "simulator/stack.h"
#include "support/random_microsurfaces.h"

namespace lacquer {
namespace {

struct Errors {
    double sum = 0.0, most = 0.0;
    int count = 0;

    void add(double error) {
        sum += std::abs(error);
        most = std::max(most, std::abs(error));
        ++count;
    }
    double mean() const { return sum / count; }
};

struct Bounds {
    double mean, most;
};

void expect_within(const Errors& errors, const Bounds& bounds, const std::string& what) {
    fmt::print("{}: mean {:.4f}, max {:.4f} of {}\n", what, errors.mean(), errors.most,
               errors.count);
    EXPECT_LT(errors.mean(), bounds.mean) << what;
    EXPECT_LT(errors.most, bounds.most) << what;
}

glm::dvec3 random_direction(std::mt19937_64& generator, double side) {
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    const double cosine = 0.03 + 0.97 * uniform(generator);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double phi = 2.0 * std::numbers::pi * uniform(generator);
    return {sine * std::cos(phi), sine * std::sin(phi), side * cosine};
}

// What leaves above, below, and from a conductor.
simulator::GoniophotometerEstimate simulated(const Material& material, const glm::dvec3& wo,
                                             std::uint64_t walks, std::uint64_t seed) {
    const simulator::StackWalk stack{material};
    return wo.z > 0.0 ? estimate_distribution(stack, wo, {1, 1}, {walks, seed, {}})
                      : estimate_distribution_from_below(stack, wo, {1, 1}, {walks, seed, {}});
}

void expect_conductors(int surfaces, std::uint64_t walks, const Bounds& bounds) {
    std::mt19937_64 generator{20230910};
    Errors errors;
    for (int n = 0; n < surfaces; ++n) {
        const Material material = test::random_conductor(generator, 1 + n % 3);
        const glm::dvec3 wo = random_direction(generator, 1.0);
        const auto truth = simulated(material, wo, walks, static_cast<std::uint64_t>(n) + 1);
        const auto light = albedo(reference::prepare_microsurface_compensated(material), wo);
        for (int c = 0; c < 3; ++c)
            errors.add(light.base[c] - truth.base.energy.mean[static_cast<std::size_t>(c)]);
    }
    expect_within(errors, bounds, "conductors");
}

// Of interfaces whose medium is clear, from the side of the lower index and from the other.
void expect_interfaces(int surfaces, std::uint64_t walks, const Bounds& thin, const Bounds& dense) {
    std::mt19937_64 generator{20230911};
    Errors from_thin, from_dense;
    for (int n = 0; n < surfaces; ++n) {
        Material material = test::random_dielectric(generator, 1 + n % 3);
        material.layers.front().medium = AbsorbingMedium{};
        const auto surface = reference::prepare_microsurface_compensated(material);
        const double side = n % 2 == 0 ? 1.0 : -1.0;
        const glm::dvec3 wo = random_direction(generator, side);
        const auto truth = simulated(material, wo, walks, static_cast<std::uint64_t>(n) + 1);
        const auto light = albedo(surface, wo);
        const double up = truth.direct.energy.mean[0], down = truth.transmitted.energy.mean[0];
        const bool is_dense = (eta_of(surface.single.above) > 1.0) == (side < 0.0);
        Errors& errors = is_dense ? from_dense : from_thin;
        errors.add(light.direct.x - (side > 0.0 ? up : down));
        errors.add(light.transmitted.x - (side > 0.0 ? down : up));
    }
    expect_within(from_thin, thin, "interfaces, from the lower index");
    expect_within(from_dense, dense, "interfaces, from the higher index");
}

TEST(MicrosurfaceCompensatedSimulation, Conductors) {
    expect_conductors(24, 20'000, {0.006, 0.04});
}

TEST(MicrosurfaceCompensatedSimulation, Interfaces) {
    expect_interfaces(16, 10'000, {0.012, 0.05}, {0.025, 0.15});
}

TEST(MicrosurfaceCompensatedSimulationFull, ManyConductors) {
    expect_conductors(150, 100'000, {0.005, 0.04});
}

TEST(MicrosurfaceCompensatedSimulationFull, ManyInterfaces) {
    expect_interfaces(120, 50'000, {0.01, 0.05}, {0.025, 0.15});
}

}  // namespace
}  // namespace lacquer
