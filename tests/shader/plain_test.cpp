// The reflection lobe and the plain model of the shader source.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "shader/shader.h"
#include "support/quadrature.h"

namespace lacquer::shader_test {
namespace {

using shader::LqOneCoat;

constexpr double kPi = std::numbers::pi;

LqOneCoat glaze(double alpha, double eta, double albedo) {
    const shader::LqFacets coat{shader::LQ_NDF_GGX, real(alpha), real(alpha)};
    return shader::lq_plain_prepare({coat, real(eta), vec3(real(0.0)), shader::LQ_BASE_LAMBERTIAN,
                                     vec3(real(albedo)), coat, vec3(real(1.0)), vec3(real(0.0))});
}

LqOneCoat metal(int ndf, double alpha_x, double alpha_y) {
    const shader::LqFacets facets{ndf, real(alpha_x), real(alpha_y)};
    return shader::lq_plain_prepare(
        {facets, real(0.0), vec3(real(0.0)), shader::LQ_BASE_CONDUCTOR, vec3(real(0.0)), facets,
         vec3(real(0.143), real(0.375), real(1.442)), vec3(real(3.983), real(2.386), real(1.603))});
}

std::vector<LqOneCoat> surfaces() {
    LqOneCoat coated_metal = metal(shader::LQ_NDF_BECKMANN, 0.3, 0.3);
    coated_metal.coat_eta = real(1.5);
    LqOneCoat glass = glaze(0.2, 1.5, 0.0);
    glass.base = shader::LQ_BASE_NONE;
    return {glaze(0.3, 1.5, 0.8), metal(shader::LQ_NDF_GGX, 0.2, 0.6),
            metal(shader::LQ_NDF_BECKMANN, 0.4, 0.4), coated_metal, glass};
}

TEST(Reflection, LobeIsReciprocal) {
    for (const LqOneCoat& surface : surfaces()) {
        const vec3 wi = direction(1.2, 0.4);
        const vec3 wo = direction(0.5, 2.9);
        const double forward =
            static_cast<double>(shader::lq_reflection_lobe(surface.coat, wi, wo));
        const double backward =
            static_cast<double>(shader::lq_reflection_lobe(surface.coat, wo, wi));
        EXPECT_NEAR(forward, backward, forward * roundings(8));
    }
}

TEST(Reflection, HalfwayCosineIsThatOfBothDirections) {
    const vec3 wi = direction(1.57, 0.0);
    const vec3 wo = direction(1.56, kPi - 0.01);  // nearly opposite: the dot product is near -1
    const double cosine = static_cast<double>(shader::lq_cos_theta_halfway(wi, wo));
    const double expected = glm::length(widen(wi) + widen(wo)) / 2;
    EXPECT_NEAR(cosine, expected, expected * roundings(8));
}

TEST(Plain, PdfIntegratesToTheFractionThatLeavesUpwards) {
    // Visible normals mirror some of wo below the surface; lq_reflection_sample tells how much.
    for (const LqOneCoat& surface : surfaces()) {
        const vec3 wo = direction(1.0, 0.3);
        const double integral = test::integrate_hemisphere(
            [&](const glm::dvec3& w) {
                const vec3 wi(real(w.x), real(w.y), real(w.z));
                return static_cast<double>(shader::lq_plain_pdf(surface, wi, wo));
            },
            600);
        constexpr int kCount = 1 << 16;
        double upwards = 0.0;
        for (unsigned i = 0; i < kCount; ++i) {
            const shader::vec4 u = shader::lq_random_uniforms(glm::uvec4(i, 5u, 0u, 0u));
            upwards += shader::lq_plain_sample(surface, wo, vec3(u.x, u.y, u.z)).pdf > 0 ? 1 : 0;
        }
        upwards /= kCount;
        const double error = 4.0 * std::sqrt(upwards * (1 - upwards) / kCount) + 1e-3;
        EXPECT_NEAR(integral, upwards, error);
    }
}

TEST(Plain, AlbedoIsTheIntegralOfEvalCos) {
    constexpr int kPoints = 4096;
    constexpr double kPointError = 2e-3;  // of 4096 low-discrepancy points, by doubling them
    for (const LqOneCoat& surface : surfaces()) {
        const vec3 wo = direction(0.8, 1.0);
        const double integral = test::integrate_hemisphere(
            [&](const glm::dvec3& w) {
                const vec3 wi(real(w.x), real(w.y), real(w.z));
                return static_cast<double>(shader::lq_plain_eval_cos(surface, wi, wo).y);
            },
            600);
        const shader::LqAlbedo albedo = shader::lq_plain_albedo(surface, wo, kPoints);
        EXPECT_NEAR(static_cast<double>(albedo.direct.y + albedo.base.y), integral, kPointError);
    }
}

TEST(Plain, SampleWeightIsEvalCosOverPdf) {
    for (const LqOneCoat& surface : surfaces())
        for (unsigned i = 0; i < 1000; ++i) {
            const shader::vec4 u = shader::lq_random_uniforms(glm::uvec4(i, 9u, 0u, 0u));
            const vec3 wo = direction(1.5 * static_cast<double>(u.w), 0.7);
            const shader::LqSample chosen =
                shader::lq_plain_sample(surface, wo, vec3(u.x, u.y, u.z));
            if (chosen.pdf == real(0.0)) {
                EXPECT_EQ(chosen.weight, vec3(real(0.0)));
                continue;
            }
            const vec3 f = shader::lq_plain_eval_cos(surface, chosen.wi, wo);
            EXPECT_NEAR(static_cast<double>(chosen.weight.x * chosen.pdf), static_cast<double>(f.x),
                        static_cast<double>(f.x) * roundings(8));
        }
}

TEST(Plain, BareLambertianBaseIsAlbedoOverPi) {
    const LqOneCoat surface = glaze(0.3, 0.0, 0.6);
    const vec3 f = shader::lq_plain_eval(surface, direction(0.3, 0.0), direction(1.2, 1.0));
    EXPECT_NEAR(static_cast<double>(f.x), 0.6 / kPi, roundings(4));
}

TEST(Plain, NothingIsReflectedThroughTheSurface) {
    for (const LqOneCoat& surface : surfaces()) {
        EXPECT_EQ(shader::lq_plain_eval(surface, direction(2.0, 0.0), direction(1.0, 0.0)),
                  vec3(real(0.0)));
        EXPECT_EQ(shader::lq_plain_pdf(surface, direction(1.0, 0.0), direction(2.0, 0.0)),
                  real(0.0));
        EXPECT_EQ(shader::lq_plain_sample(surface, direction(2.0, 0.0), vec3(real(0.5))).pdf,
                  real(0.0));
    }
}

TEST(Plain, IsFiniteAndNonNegativeForAnyFiniteInput) {
    const double values[] = {0.0, -0.0, 1e-38, 1e-12, 1e-4, 0.6, 1.0, -1.0, 1e4, 1e38};
    std::vector<vec3> directions;
    for (const double x : values)
        for (const double z : values) directions.emplace_back(real(x), real(0.0), real(z));
    for (const double x : {1e-20, 0.70710678, 1.0})
        directions.emplace_back(real(x), real(-x), real(x));
    const auto sound = [](Real value) {
        return value >= real(0.0) && value <= std::numeric_limits<Real>::max();
    };
    for (const double alpha : {0.0, 1e-3, 1.0, 1e30, -5.0})
        for (const double eta : {0.0, 1e-20, 1.0, 3.0, 1e30})
            for (const int base : {0, 1, 2, 99}) {
                const shader::LqFacets facets{base % 2, real(alpha), real(alpha / 2)};
                const LqOneCoat surface = shader::lq_plain_prepare(
                    {facets, real(eta), vec3(real(alpha)), base, vec3(real(eta)), facets,
                     vec3(real(eta)), vec3(real(alpha))});
                for (const vec3& wi : directions)
                    for (const vec3& wo : directions) {
                        const vec3 f = shader::lq_plain_eval_cos(surface, wi, wo);
                        const Real pdf = shader::lq_plain_pdf(surface, wi, wo);
                        ASSERT_TRUE(sound(f.x) && sound(f.y) && sound(f.z) && sound(pdf))
                            << alpha << " " << eta << " " << base << " wi " << wi.x << " " << wi.z
                            << " wo " << wo.x << " " << wo.z << " f " << f.x << " pdf " << pdf;
                    }
                for (const vec3& wo : directions) {
                    const shader::LqSample chosen =
                        shader::lq_plain_sample(surface, wo, vec3(real(0.3), real(0.9), real(0.5)));
                    ASSERT_TRUE(sound(chosen.weight.x) && sound(chosen.pdf))
                        << alpha << " " << eta << " " << base << " wo " << wo.x << " " << wo.z;
                    const shader::LqAlbedo albedo = shader::lq_plain_albedo(surface, wo, 4);
                    ASSERT_TRUE(sound(albedo.direct.x) && sound(albedo.base.x));
                }
            }
}

}  // namespace
}  // namespace lacquer::shader_test
