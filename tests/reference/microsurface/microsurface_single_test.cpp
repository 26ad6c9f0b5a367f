// The model `microsurface-single`: what every model holds, and what its closed forms promise.
#include "reference/microsurface/microsurface_single.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/error.h"
#include "integrate.h"
#include "reference/plain.h"
#include "support/chi_square.h"
#include "support/quadrature.h"
#include "support/random_microsurfaces.h"
#include "support/sampling_fit.h"

namespace lacquer::reference {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

glm::dvec3 mirrored_down(const glm::dvec3& w) {
    return {w.x, w.y, -w.z};
}

struct Case {
    std::string name;
    Material material;
};

Stratum stratum(double weight, Ndf ndf, double alpha_x, double alpha_y) {
    return {weight, {ndf, {alpha_x, alpha_y}}, {}, {}, {}};
}

Blend three(Blend::Operator op) {
    return {op,
            {stratum(0.3, Ndf::ggx, 0.9, 0.9), stratum(0.3, Ndf::beckmann, 0.6, 0.9),
             stratum(0.4, Ndf::ggx, 0.7, 0.7)}};
}

Material conductor(Roughness roughness) {
    return {"conductor",
            1.0,
            {},
            ConductorBase{{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}, std::move(roughness)},
            {}};
}

Material dielectric(double ior, Roughness roughness, Medium medium = {}) {
    return {"dielectric", 1.0, {{{ior, std::move(roughness)}, medium}}, NoBase{}, {}};
}

Material two_metals() {
    Blend blend{Blend::Operator::asymmetric,
                {stratum(0.5, Ndf::ggx, 0.3, 0.3), stratum(0.5, Ndf::ggx, 0.7, 0.7)}};
    blend.strata[0].eta = Rgb{2.9, 2.9, 2.6};
    blend.strata[0].kappa = Rgb{3.1, 2.9, 2.8};
    return conductor(blend);
}

const std::vector<Case>& cases() {
    using Op = Blend::Operator;
    static const std::vector<Case> all{
        {"uniform metal", conductor(Microsurface{Ndf::ggx, {0.3, 0.5}})},
        {"layered metal", conductor(three(Op::asymmetric))},
        {"mixed metal", conductor(three(Op::symmetric))},
        {"two metals", two_metals()},
        {"uniform glass", dielectric(1.5, Microsurface{Ndf::ggx, {0.8, 0.8}})},
        {"layered glass", dielectric(1.5, three(Op::asymmetric))},
        {"mixed glass", dielectric(1.8, three(Op::symmetric))},
        {"tinted bubble",
         dielectric(0.75, three(Op::asymmetric), AbsorbingMedium{{0.9, 0.5, 0.2}})},
    };
    return all;
}

std::vector<glm::dvec3> viewers() {
    std::vector<glm::dvec3> all;
    for (const double cosine : {1.0, 0.35}) {
        all.push_back(test::direction(cosine, 0.4));
        all.push_back(mirrored_down(all.back()));
    }
    return all;
}

double index_at(const Material& material, const glm::dvec3& w) {
    if (w.z >= 0.0 || material.layers.empty()) return 1.0;
    return material.layers.front().interface.ior;
}

TEST(MicrosurfaceSingle, IsReciprocal) {
    constexpr double kRounding = 1e-9;  // of normals, on the flanks of D
    std::mt19937_64 generator{5};
    std::uniform_real_distribution<double> uniform{-1.0, 1.0};
    for (const auto& [name, material] : cases()) {
        const SingleMicrosurface surface = prepare_microsurface_single(material);
        for (int n = 0; n < 500; ++n) {
            const auto next = [&] {
                const glm::dvec3 w =
                    test::direction(std::abs(uniform(generator)), 3.0 * uniform(generator));
                return uniform(generator) < 0.0 && surface.below ? mirrored_down(w) : w;
            };
            const glm::dvec3 wi = next(), wo = next();
            const double scale =
                surface.below ? std::pow(index_at(material, wi) / index_at(material, wo), 2) : 1.0;
            const glm::dvec3 there = eval(surface, wi, wo), back = eval(surface, wo, wi) * scale;
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(there[c], back[c], kRounding * back[c]) << name << " query " << n;
        }
    }
}

TEST(MicrosurfaceSingle, SampleFollowsItsDensity) {
    const double significance =
        test::sidak_significance(0.01, 2 * static_cast<int>(cases().size()));
    for (const auto& [name, material] : cases()) {
        const SingleMicrosurface surface = prepare_microsurface_single(material);
        // Light refracted by vertical facets has an edge, which midpoints miss at grazing angles.
        for (const glm::dvec3& wo : {test::direction(0.8, 0.4), -test::direction(0.7, 0.4)}) {
            if (wo.z < 0.0 && !surface.below) continue;
            test::expect_sphere_sampling_fit(
                [&](const glm::dvec3& u) -> std::optional<glm::dvec3> {
                    const Sample chosen = sample(surface, wo, u);
                    if (!(chosen.pdf > 0.0)) return std::nullopt;
                    return chosen.wi;
                },
                [&](const glm::dvec3& wi) { return pdf(surface, wi, wo); }, significance,
                name + " from " + std::to_string(wo.z));
        }
    }
}

// f |cos_theta_i| / pdf is what the sample says, and no more than masking leaves: Smith's shadowing
// only takes away.
TEST(MicrosurfaceSingle, WeightsAreBounded) {
    constexpr double kRounding = 1e-12;
    std::mt19937_64 generator{6};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    for (const auto& [name, material] : cases()) {
        const SingleMicrosurface surface = prepare_microsurface_single(material);
        for (const glm::dvec3& wo : viewers())
            for (int n = 0; n < 2000; ++n) {
                const glm::dvec3 u{uniform(generator), uniform(generator), uniform(generator)};
                const Sample chosen = sample(surface, wo, u);
                if (!(chosen.pdf > 0.0)) continue;
                EXPECT_NEAR(chosen.pdf, pdf(surface, chosen.wi, wo), kRounding * chosen.pdf);
                for (int c = 0; c < 3; ++c) {
                    EXPECT_GE(chosen.weight[c], 0.0) << name;
                    EXPECT_LE(chosen.weight[c], 1.0 + kRounding) << name;
                }
            }
    }
}

TEST(MicrosurfaceSingle, WeightsAverageToTheAlbedo) {
    constexpr int kPoints = 1 << 16;
    // Where a sample jumps from one stratum or side to another the points are even to 1 / sqrt(n).
    constexpr double kPointError = 4e-3;
    for (const auto& [name, material] : cases()) {
        const SingleMicrosurface surface = prepare_microsurface_single(material);
        for (const glm::dvec3& wo : {test::direction(0.5, 0.4), -test::direction(0.7, 0.4)}) {
            if (wo.z < 0.0 && !surface.below) continue;
            const Albedo expected = albedo(surface, wo);
            const auto mean_of = [&](bool through) {
                return test::mean_over_cube(
                    [&](const glm::dvec3& u) {
                        const Sample chosen = sample(surface, wo, u);
                        if ((chosen.wi.z * wo.z < 0.0) != through) return glm::dvec3{0.0};
                        return chosen.weight;
                    },
                    kPoints);
            };
            const glm::dvec3 reflected = mean_of(false), through = mean_of(true);
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(reflected[c], expected.direct[c] + expected.base[c], kPointError)
                    << name << " from " << wo.z;
                EXPECT_NEAR(through[c], expected.transmitted[c], kPointError)
                    << name << " from " << wo.z;
            }
        }
    }
}

TEST(MicrosurfaceSingle, ReturnsNoMoreThanItGets) {
    std::mt19937_64 generator{7};
    for (int n = 0; n < 12; ++n) {
        const Material material = n % 2 == 0 ? test::random_dielectric(generator, 1 + n / 2 % 3)
                                             : test::random_conductor(generator, 1 + n / 2 % 3);
        const SingleMicrosurface surface = prepare_microsurface_single(material);
        for (const double cosine : {1.0, 0.4, 0.02}) {
            const Albedo light = albedo(surface, test::direction(cosine, 1.0));
            for (int c = 0; c < 3; ++c) {
                const double all = light.direct[c] + light.base[c] + light.transmitted[c];
                EXPECT_GT(all, 0.0);
                EXPECT_LE(all, 1.0 + 1e-6) << test::describe(material) << " from " << cosine;
            }
        }
    }
}

TEST(MicrosurfaceSingle, OfUniformFacetsReflectsAsPlainDoes) {
    const Microsurface facets{Ndf::beckmann, {0.3, 0.6}};
    for (const Material& material : {conductor(facets), dielectric(1.5, facets)}) {
        const SingleMicrosurface surface = prepare_microsurface_single(material);
        const PlainSurface plain = prepare_plain(material);
        for (const double cosine : {1.0, 0.5, 0.1}) {
            const glm::dvec3 wi = test::direction(0.7, 2.5), wo = test::direction(cosine, 0.2);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(eval(surface, wi, wo)[c], eval(plain, wi, wo)[c], 1e-12);
            const Albedo light = albedo(surface, wo), expected = albedo(plain, wo);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR((light.direct + light.base)[c], (expected.direct + expected.base)[c],
                            1e-6);
        }
    }
}

TEST(MicrosurfaceSingle, OfEqualStrataIsUniform) {
    const Microsurface facets{Ndf::ggx, {0.3, 0.6}};
    Blend blend;
    for (const double weight : {0.2, 0.5, 0.3})
        blend.strata.push_back({weight, facets, {}, {}, {}});
    for (const auto op : {Blend::Operator::symmetric, Blend::Operator::asymmetric}) {
        blend.op = op;
        const SingleMicrosurface cut = prepare_microsurface_single(dielectric(1.5, blend));
        const SingleMicrosurface whole = prepare_microsurface_single(dielectric(1.5, facets));
        for (const glm::dvec3& wo : viewers())
            for (const glm::dvec3& wi : viewers()) {
                const double expected = eval(whole, wi, wo).x;
                EXPECT_NEAR(eval(cut, wi, wo).x, expected, 1e-10 * expected);
                EXPECT_NEAR(pdf(cut, wi, wo), pdf(whole, wi, wo), 1e-10 * pdf(whole, wi, wo));
            }
    }
}

// The order of strata matters, which is what the model is for: at grazing angles the top dominates.
TEST(MicrosurfaceSingle, OfTurnedStrataIsNotTheSame) {
    Blend blend{Blend::Operator::asymmetric,
                {stratum(0.5, Ndf::ggx, 0.1, 0.1), stratum(0.5, Ndf::ggx, 0.8, 0.8)}};
    const SingleMicrosurface smooth_top = prepare_microsurface_single(conductor(blend));
    std::swap(blend.strata[0], blend.strata[1]);
    const SingleMicrosurface rough_top = prepare_microsurface_single(conductor(blend));
    const glm::dvec3 wo = test::direction(0.1, 0.0), wi = test::direction(0.1, 3.14159);
    EXPECT_GT(eval(smooth_top, wi, wo).x, 2.0 * eval(rough_top, wi, wo).x);
}

TEST(MicrosurfaceSingle, BetweenEqualIndicesLightGoesStraightOn) {
    const SingleMicrosurface surface = prepare_microsurface_single(
        dielectric(1.0, Microsurface{Ndf::ggx, {0.3, 0.3}}, AbsorbingMedium{{1.0, 0.5, 0.25}}));
    const glm::dvec3 wo = test::direction(0.5, 0.3);
    EXPECT_EQ(eval(surface, -wo, wo), glm::dvec3{0.0});
    EXPECT_EQ(sample(surface, wo, {0.5, 0.5, 0.5}).pdf, 0.0);
    for (const glm::dvec3& w : {wo, -wo}) {
        const Albedo light = albedo(surface, w);
        EXPECT_EQ(light.direct, glm::dvec3{0.0});
        EXPECT_NEAR(light.transmitted.x, 1.0, 1e-15);
        EXPECT_NEAR(light.transmitted.y, 0.25, 1e-15);
        EXPECT_NEAR(light.transmitted.z, 0.0625, 1e-15);
    }
}

// Light along the surface, smooth facets, strata of next to nothing.
TEST(MicrosurfaceSingle, IsFiniteEverywhere) {
    const Blend blend{Blend::Operator::asymmetric,
                      {stratum(1e-12, Ndf::ggx, 1.0, 1.0), stratum(0.5, Ndf::beckmann, 0.0, 0.0),
                       stratum(0.5 - 1e-12, Ndf::ggx, 0.0, 1.0)}};
    for (const Material& material :
         {conductor(blend), dielectric(0.5, blend), dielectric(1.0 + 1e-7, blend)}) {
        const SingleMicrosurface surface = prepare_microsurface_single(material);
        for (const double cosine : {1.0, 0.3, 1e-6, 1e-30, 0.0})
            for (const double other : {1.0, 0.3, 1e-6, 1e-30, 0.0})
                for (const double side : {1.0, -1.0}) {
                    const glm::dvec3 wo = test::direction(cosine, 0.4);
                    glm::dvec3 wi = test::direction(other, 3.0);
                    wi.z *= side;
                    const glm::dvec3 f = eval(surface, wi, wo);
                    const Sample chosen = sample(surface, wo, {other, 0.3, 0.999});
                    for (const double value :
                         {f.x, f.y, f.z, pdf(surface, wi, wo), chosen.pdf, chosen.weight.x}) {
                        EXPECT_TRUE(std::isfinite(value)) << cosine << " " << other << " " << side;
                        EXPECT_GE(value, 0.0) << cosine << " " << other << " " << side;
                    }
                }
    }
}

TEST(MicrosurfaceSingle, NamesWhatItCannotShade) {
    const auto message = [](const Material& material) {
        try {
            prepare_microsurface_single(material);
        } catch (const Error& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    const Microsurface facets{Ndf::ggx, {0.3, 0.3}};
    Material coated = dielectric(1.5, facets);
    coated.base = LambertianBase{{0.5, 0.5, 0.5}};
    EXPECT_THAT(message(coated), HasSubstr("/base: the model 'microsurface-single'"));
    coated.layers.clear();
    EXPECT_THAT(message(coated), HasSubstr("/base: the model 'microsurface-single'"));
    Material twice = dielectric(1.5, facets);
    twice.layers.push_back(twice.layers.front());
    EXPECT_THAT(message(twice), HasSubstr("/layers/1"));
    Material cloudy = dielectric(1.5, facets, ScatteringMedium{{}, {1, 1, 1}, 0.0, 1.0});
    EXPECT_THAT(message(cloudy), HasSubstr("/layers/0/medium/sigma_s"));
    Blend blend = three(Blend::Operator::asymmetric);
    blend.strata[1].albedo = Rgb{0.5, 0.5, 0.5};
    EXPECT_THAT(message(conductor(blend)), HasSubstr("/base/conductor/blend/strata/1/albedo"));
    blend = three(Blend::Operator::asymmetric);
    blend.strata.resize(kMaxStrata + 1, blend.strata.back());
    EXPECT_THAT(message(conductor(blend)), HasSubstr("/base/conductor/blend/strata/4"));
}

}  // namespace
}  // namespace lacquer::reference
