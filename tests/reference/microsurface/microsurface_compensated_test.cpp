// The model `microsurface-compensated`: what every model holds, and where it is that of one facet.
#include "reference/microsurface/microsurface_compensated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "support/random_microsurfaces.h"
#include "support/sampling_fit.h"

namespace lacquer::reference {
namespace {

glm::dvec3 random_direction(std::mt19937_64& generator, bool refracts) {
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    const double cosine = 0.02 + 0.98 * uniform(generator);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double phi = 2.0 * std::numbers::pi * uniform(generator);
    const double side = refracts && uniform(generator) < 0.5 ? -1.0 : 1.0;
    return {sine * std::cos(phi), sine * std::sin(phi), side * cosine};
}

Material random_material(std::mt19937_64& generator, int n) {
    const int strata = 1 + n % 4;
    return n % 2 == 0 ? test::random_conductor(generator, strata)
                      : test::random_dielectric(generator, strata);
}

// Beyond rounding the part let through is reciprocal because it was made so on average, to what the
// quotients of averages keep.
constexpr double kReciprocity = 1e-9;

TEST(MicrosurfaceCompensated, IsReciprocal) {
    std::mt19937_64 generator{20230903};
    for (int n = 0; n < 40; ++n) {
        const Material material = random_material(generator, n);
        const auto surface = prepare_microsurface_compensated(material);
        const bool refracts = surface.single.below.has_value();
        const double eta = refracts ? eta_of(surface.single.above) : 1.0;
        const auto index = [&](const glm::dvec3& w) { return is_below(w) ? eta : 1.0; };
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 wi = random_direction(generator, refracts);
            const glm::dvec3 wo = random_direction(generator, refracts);
            const double there = eval(surface, wi, wo).x / (index(wi) * index(wi));
            const double back = eval(surface, wo, wi).x / (index(wo) * index(wo));
            EXPECT_NEAR(there, back, kReciprocity * (there + back)) << test::describe(material);
        }
    }
}

TEST(MicrosurfaceCompensated, AddsToWhatMetOneFacet) {
    std::mt19937_64 generator{20230904};
    for (int n = 0; n < 40; ++n) {
        const Material material = random_material(generator, n);
        const auto surface = prepare_microsurface_compensated(material);
        const bool refracts = surface.single.below.has_value();
        const glm::dvec3 wi = random_direction(generator, refracts);
        const glm::dvec3 wo = random_direction(generator, refracts);
        const glm::dvec3 one = eval(surface.single, wi, wo), all = eval(surface, wi, wo);
        for (int c = 0; c < 3; ++c) EXPECT_GE(all[c], one[c]) << test::describe(material);
    }
}

// Facets of alpha 0.01 send next to nothing to others but at grazing.
TEST(MicrosurfaceCompensated, OfSmoothFacetsIsThatOfOneFacet) {
    const Material smooth{
        "smooth",
        1.0,
        {},
        ConductorBase{{0.2, 0.4, 1.4}, {4.0, 2.4, 1.6}, Microsurface{Ndf::ggx, {0.01, 0.01}}},
        {}};
    const auto surface = prepare_microsurface_compensated(smooth);
    const auto shares =
        several_shares(surface.several.turning, surface.several.above, {0.6, 0.0, 0.8});
    EXPECT_LT(shares.reflected.x, 1e-3);
}

TEST(MicrosurfaceCompensated, SampleFollowsItsDensity) {
    std::mt19937_64 generator{20230905};
    constexpr int kSurfaces = 4;
    for (int n = 0; n < kSurfaces; ++n) {
        const int strata = 1 + n;
        Material material = n % 2 == 0 ? test::random_conductor(generator, strata, 0.5)
                                       : test::random_dielectric(generator, strata, 0.5);
        // Far enough from 1 for lobes that the midpoint rule can integrate.
        if (n % 2 == 1) material.layers.front().interface.ior = n == 1 ? 1.8 : 0.6;
        const auto surface = prepare_microsurface_compensated(material);
        const glm::dvec3 wo = random_direction(generator, n % 2 == 1);
        test::expect_sphere_sampling_fit(
            [&](const glm::dvec3& u) -> std::optional<glm::dvec3> {
                const Sample chosen = sample(surface, wo, u);
                if (chosen.pdf <= 0.0) return std::nullopt;
                return chosen.wi;
            },
            [&](const glm::dvec3& wi) { return pdf(surface, wi, wo); }, 0.01 / kSurfaces,
            test::describe(material));
    }
}

// By the samples of a Halton-like lattice, whose weights are bounded: to 4 / sqrt(n) of their
// spread.
TEST(MicrosurfaceCompensated, WeightsAverageToTheAlbedo) {
    std::mt19937_64 generator{20230906};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    for (int n = 0; n < 8; ++n) {
        const Material material = random_material(generator, n);
        const auto surface = prepare_microsurface_compensated(material);
        const glm::dvec3 wo = random_direction(generator, surface.single.below.has_value());
        constexpr int kSamples = 40'000;
        double sum = 0.0, squares = 0.0;
        for (int k = 0; k < kSamples; ++k) {
            const Sample chosen =
                sample(surface, wo, {uniform(generator), uniform(generator), uniform(generator)});
            sum += chosen.weight.x;
            squares += chosen.weight.x * chosen.weight.x;
        }
        const double average = sum / kSamples;
        const double error =
            std::sqrt(std::max(squares / kSamples - average * average, 0.0) / kSamples);
        const Albedo light = albedo(surface, wo);
        // The polynomials of m cross 0 near grazing, where they are clamped: their average is not
        // quite that of what is shaded.
        constexpr double kClamping = 2e-3;
        EXPECT_NEAR(light.direct.x + light.base.x + light.transmitted.x, average,
                    4.0 * error + kClamping)
            << test::describe(material);
    }
}

// Without the strata's own indices.
Material of_one_metal(Material material) {
    auto& conductor = std::get<ConductorBase>(material.base);
    if (auto* blend = std::get_if<Blend>(&conductor.roughness))
        for (Stratum& stratum : blend->strata) stratum.eta = stratum.kappa = std::nullopt;
    return material;
}

TEST(MicrosurfaceCompensated, ReturnsAllLightOfMirrors) {
    std::mt19937_64 generator{20230907};
    double sum = 0.0;
    constexpr int kSurfaces = 40;
    for (int n = 0; n < kSurfaces; ++n) {
        const Material material =
            of_one_metal(test::mirrors(test::random_conductor(generator, 1 + n % 3)));
        const auto surface = prepare_microsurface_compensated(material);
        const glm::dvec3 wo = random_direction(generator, false);
        const double light = albedo(surface, wo).base.x;
        sum += std::abs(light - 1.0);
        // Between the planes of strongly anisotropic strata m is a guess (README).
        EXPECT_NEAR(light, 1.0, 0.05) << test::describe(material);
    }
    EXPECT_LT(sum / kSurfaces, 0.005);
}

// Of alpha 0.05 nearly all of m lies below a cosine of 0.1, where the polynomial has three nodes:
// it is 0.024 off at most.
constexpr double kNarrow = 0.03;

TEST(MicrosurfaceCompensated, OfIsotropicMirrorsIsAFurnace) {
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        for (const double alpha : {0.05, 0.2, 0.5, 0.8, 1.0})
            for (const double cosine : {0.05, 0.2, 0.5, 0.8, 1.0}) {
                const Material material = test::mirrors(
                    {"metal",
                     1.0,
                     {},
                     ConductorBase{{1, 1, 1}, {1, 1, 1}, Microsurface{ndf, {alpha, alpha}}},
                     {}});
                const auto surface = prepare_microsurface_compensated(material);
                const glm::dvec3 wo{std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
                EXPECT_NEAR(albedo(surface, wo).base.x, 1.0, alpha < 0.1 ? kNarrow : 0.005)
                    << test::describe(material) << " at " << cosine;
            }
}

TEST(MicrosurfaceCompensated, IsFiniteEverywhere) {
    std::mt19937_64 generator{20230908};
    for (int n = 0; n < 8; ++n) {
        const Material material = random_material(generator, n);
        const auto surface = prepare_microsurface_compensated(material);
        for (const glm::dvec3& wo : {glm::dvec3{0, 0, 1}, glm::dvec3{0, 0, -1}, glm::dvec3{1, 0, 0},
                                     glm::dvec3{1, 0, 1e-12}, glm::dvec3{0, 1, -1e-12}})
            for (const glm::dvec3& wi : {glm::dvec3{0, 0, 1}, glm::dvec3{0, 1, 0},
                                         glm::dvec3{0, 1, 1e-12}, glm::dvec3{0, 0, -1}}) {
                const glm::dvec3 f = eval(surface, wi, wo);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_TRUE(std::isfinite(f[c]));
                    EXPECT_GE(f[c], 0.0);
                }
                EXPECT_GE(pdf(surface, wi, wo), 0.0);
            }
    }
}

}  // namespace
}  // namespace lacquer::reference
