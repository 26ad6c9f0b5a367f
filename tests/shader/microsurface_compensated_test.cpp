// Surfaces with all the light that their facets send on: the shader source against the reference.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "reference/microsurface/microsurface_compensated.h"
#include "shader.h"
// After the shader source:
#include "shading/microsurface_material.h"
#include "support/random_microsurfaces.h"

namespace lacquer::shader_test {
namespace {

// The closed form of one facet is off by 1e-5 where its continued fraction and its logarithms end
// early, in both precisions; in float the flank of a lobe of alpha 0.05 answers to the slope of its
// normal by 4 / alpha, and that carries some ten roundings. Below the dark value light is compared
// absolutely: it is what is left of sums of 1.
constexpr double kRelative = 2e-5 + 4.0 / 0.05 * roundings(10);
constexpr double kDark = 1e-3;

// What facets leave over is the rest of 1, of 64 terms that carry some eight roundings each.
constexpr double kLeftOver = roundings(64 * 8);

struct Directions {
    glm::dvec3 wi, wo;
};

glm::dvec3 random_direction(std::mt19937_64& generator, bool refracts) {
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    const double cosine = 0.02 + 0.98 * uniform(generator);
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const double phi = 2.0 * std::numbers::pi * uniform(generator);
    const double side = refracts && uniform(generator) < 0.5 ? -1.0 : 1.0;
    return widen({real(sine * std::cos(phi)), real(sine * std::sin(phi)), real(side * cosine)});
}

vec3 narrow(const glm::dvec3& w) {
    return {real(w.x), real(w.y), real(w.z)};
}

struct Pair {
    reference::CompensatedMicrosurface expected;
    shader::LqMicrosurfaceCompensatedSurface surface;
};

Pair prepared(const Material& material) {
    const shader::LqMicrosurfaceMaterial packed =
        to_microsurface(microsurface_parameters(material, Model::microsurface_compensated));
    return {reference::prepare_microsurface_compensated(material),
            lq_microsurface_compensated_prepare(
                packed, lq_several_facets(lq_microsurface_prepare(packed)))};
}

void expect_near(double value, double expected, const Material& material) {
    EXPECT_NEAR(value, expected, kRelative * (std::abs(expected) + kDark))
        << test::describe(material);
}

class MicrosurfaceCompensated : public testing::TestWithParam<bool> {};

TEST_P(MicrosurfaceCompensated, IsThatOfTheReference) {
    const bool refracts = GetParam();
    std::mt19937_64 generator{20230901};
    for (int n = 0; n < 12; ++n) {
        const int strata = 1 + n % 4;
        const Material material = refracts ? test::random_dielectric(generator, strata)
                                           : test::random_conductor(generator, strata);
        const Pair of = prepared(material);
        for (int k = 0; k < 20; ++k) {
            const glm::dvec3 wi = random_direction(generator, refracts);
            const glm::dvec3 wo = random_direction(generator, refracts);
            const glm::dvec3 expected = eval(of.expected, wi, wo);
            const vec3 value = lq_microsurface_compensated_eval(of.surface, narrow(wi), narrow(wo));
            for (int c = 0; c < 3; ++c)
                expect_near(static_cast<double>(value[c]), expected[c], material);
            expect_near(static_cast<double>(
                            lq_microsurface_compensated_pdf(of.surface, narrow(wi), narrow(wo))),
                        pdf(of.expected, wi, wo), material);
        }
    }
}

TEST_P(MicrosurfaceCompensated, DividesLightAsTheReference) {
    const bool refracts = GetParam();
    std::mt19937_64 generator{20230902};
    for (int n = 0; n < 12; ++n) {
        const int strata = 1 + n % 4;
        const Material material = refracts ? test::random_dielectric(generator, strata)
                                           : test::random_conductor(generator, strata);
        const Pair of = prepared(material);
        const glm::dvec3 w = random_direction(generator, false);
        const auto expect_side = [&](const reference::SeveralFacetsSide& expected,
                                     const shader::LqSeveralFacetsSide& side) {
            const auto expect_share = [&](double value, double share) {
                EXPECT_NEAR(value, share, kRelative * (share + kDark) + kLeftOver)
                    << test::describe(material);
            };
            const auto shares = several_shares(of.expected.several.turning, expected, w);
            const shader::LqSeveralShares light =
                lq_several_shares(of.surface.several.turning, side, narrow(w));
            for (int c = 0; c < 3; ++c)
                expect_share(static_cast<double>(light.reflected[c]), shares.reflected[c]);
            expect_share(static_cast<double>(light.through), shares.through);
        };
        expect_side(of.expected.several.above, of.surface.several.above);
        if (refracts) expect_side(of.expected.several.below, of.surface.several.below);
    }
}

INSTANTIATE_TEST_SUITE_P(Facets, MicrosurfaceCompensated, testing::Bool(),
                         [](const auto& is) { return is.param ? "Refract" : "Mirror"; });

}  // namespace
}  // namespace lacquer::shader_test
