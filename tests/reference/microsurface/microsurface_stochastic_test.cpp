// The model `microsurface-stochastic`: what holds for every seed, and what for the mean of them.
#include "reference/microsurface/microsurface_stochastic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "integrate.h"
#include "reference/random_numbers.h"
#include "support/sampling_fit.h"

namespace lacquer::reference {
namespace {

constexpr std::uint32_t kSeed = 11;

Stratum stratum(double weight, Ndf ndf, double alpha_x, double alpha_y) {
    return {weight, {ndf, {alpha_x, alpha_y}}, {}, {}, {}};
}

Blend blend(Blend::Operator op) {
    return {op, {stratum(0.4, Ndf::ggx, 0.9, 0.6), stratum(0.6, Ndf::beckmann, 0.5, 0.5)}};
}

// Of index i, which reflects everything.
Material conductor(Roughness roughness) {
    return {"conductor", 1.0, {}, ConductorBase{{0, 0, 0}, {1, 1, 1}, std::move(roughness)}, {}};
}

Material dielectric(double ior, Roughness roughness) {
    return {"dielectric", 1.0, {{{ior, std::move(roughness)}, {}}}, NoBase{}, {}};
}

std::vector<Material> materials() {
    using Op = Blend::Operator;
    return {conductor(blend(Op::asymmetric)), conductor(blend(Op::symmetric)),
            dielectric(1.5, blend(Op::asymmetric)), dielectric(0.7, blend(Op::symmetric))};
}

TEST(RandomNumbers, AreEvenAndUncorrelated) {
    constexpr int kCount = 1 << 16;
    double means[4] = {}, products[3] = {};
    for (std::uint32_t n = 0; n < kCount; ++n) {
        const auto u = random_numbers({5, n, 0, 1});
        for (int k = 0; k < 4; ++k) {
            ASSERT_GE(u[k], 0.0);
            ASSERT_LT(u[k], 1.0);
            means[k] += u[k] / kCount;
            if (k > 0) products[k - 1] += (u[k] - 0.5) * (u[k - 1] - 0.5) / kCount;
        }
    }
    const double deviation = 1.0 / std::sqrt(12.0 * kCount);
    for (const double mean : means) EXPECT_NEAR(mean, 0.5, 4.0 * deviation);
    for (const double product : products)
        EXPECT_NEAR(product, 0.0, 4.0 / (12.0 * std::sqrt(kCount)));
}

TEST(MicrosurfaceStochastic, RepeatsItselfForASeedOnly) {
    const auto surface = prepare_microsurface_stochastic(materials()[0]);
    const glm::dvec3 wi = test::direction(0.6, 1.0), wo = test::direction(0.8, 0.4);
    EXPECT_EQ(eval(surface, wi, wo, 1), eval(surface, wi, wo, 1));
    EXPECT_NE(eval(surface, wi, wo, 1), eval(surface, wi, wo, 2));
}

// Mirrors and glass lose nothing once all orders are there.
TEST(MicrosurfaceStochastic, ReturnsAllLight) {
    for (const Material& material : materials()) {
        const auto surface = prepare_microsurface_stochastic(material);
        for (const double cosine : {0.9, 0.2}) {
            const Albedo light = albedo(surface, test::direction(cosine, 0.4), kSeed);
            EXPECT_NEAR((light.direct + light.base + light.transmitted).x, 1.0,
                        4.0 * 0.5 / std::sqrt(kAlbedoWalks));
        }
    }
}

// Weights of samples estimate the same albedo by way of f.
TEST(MicrosurfaceStochastic, WeightsAverageToTheAlbedo) {
    constexpr int kSamples = 1 << 15;
    std::mt19937_64 generator{3};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    for (const Material& material : materials()) {
        const auto surface = prepare_microsurface_stochastic(material);
        const glm::dvec3 wo = test::direction(0.6, 0.4);
        double sum = 0.0, squares = 0.0;
        for (std::uint32_t n = 0; n < kSamples; ++n) {
            const glm::dvec3 u{uniform(generator), uniform(generator), uniform(generator)};
            const double weight = sample(surface, wo, u, n).weight.x;
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / kSamples;
        const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
        EXPECT_NEAR(mean, 1.0, 4.0 * error);
        EXPECT_LT(error, 0.02);
    }
}

TEST(MicrosurfaceStochastic, SampleFollowsItsDensity) {
    const auto surface =
        prepare_microsurface_stochastic(dielectric(1.5, blend(Blend::Operator::asymmetric)));
    const glm::dvec3 wo = test::direction(0.8, 0.4);
    test::expect_sphere_sampling_fit(
        [&](const glm::dvec3& u) -> std::optional<glm::dvec3> {
            const Sample chosen = sample(surface, wo, u, kSeed);
            if (!(chosen.pdf > 0.0)) return std::nullopt;
            return chosen.wi;
        },
        [&](const glm::dvec3& wi) { return pdf(surface, wi, wo); }, 0.01, "layered glass");
}

// Light along the surface, smooth facets, strata of next to nothing.
TEST(MicrosurfaceStochastic, IsFiniteEverywhere) {
    const Blend extreme{Blend::Operator::asymmetric,
                        {stratum(1e-12, Ndf::ggx, 1.0, 1.0), stratum(0.5, Ndf::beckmann, 0.0, 0.0),
                         stratum(0.5 - 1e-12, Ndf::ggx, 0.0, 1.0)}};
    Blend mixed = extreme;
    mixed.op = Blend::Operator::symmetric;
    for (const Material& material : {conductor(extreme), dielectric(0.5, extreme),
                                     dielectric(1.0 + 1e-7, mixed), conductor(mixed)}) {
        const auto surface = prepare_microsurface_stochastic(material);
        for (const double cosine : {1.0, 0.3, 1e-6, 1e-30, 0.0})
            for (const double other : {1.0, 0.3, 1e-6, 1e-30, 0.0})
                for (const double side : {1.0, -1.0})
                    for (std::uint32_t seed = 0; seed < 20; ++seed) {
                        const glm::dvec3 wo = test::direction(cosine, 0.4);
                        glm::dvec3 wi = test::direction(other, 3.0);
                        wi.z *= side;
                        const glm::dvec3 f = eval(surface, wi, wo, seed);
                        const Sample chosen = sample(surface, wo, {other, 0.3, 0.999}, seed);
                        for (const double value :
                             {f.x, f.y, f.z, pdf(surface, wi, wo), chosen.pdf, chosen.weight.x}) {
                            EXPECT_TRUE(std::isfinite(value))
                                << material.name << " " << cosine << " " << other << " " << side;
                            EXPECT_GE(value, 0.0) << cosine << " " << other << " " << side;
                        }
                    }
    }
}

}  // namespace
}  // namespace lacquer::reference
