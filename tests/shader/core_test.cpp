// Scalar helpers, frames, random numbers, warps and tone mapping of the shader source.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "shader/shader.h"

namespace lacquer::shader_test {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(Math, CosSinTurnIsCosineAndSineOfTheAngle) {
    constexpr double kSeriesError = 3e-8;  // first omitted Taylor term at pi / 4
    for (int i = 0; i <= 4096; ++i) {
        const Real turn = real(i / 4096.0);
        const vec2 result = shader::lq_cos_sin_turn(turn);
        const double angle = 2 * kPi * static_cast<double>(turn);
        EXPECT_NEAR(static_cast<double>(result.x), std::cos(angle), kSeriesError + roundings(4));
        EXPECT_NEAR(static_cast<double>(result.y), std::sin(angle), kSeriesError + roundings(4));
    }
}

TEST(Math, ScaledIerfcMatchesItsDefinition) {
    // The fit's error, 1.2e-7 of the t^2 scale, is largest relative to the tail 0.045 t^2.
    constexpr double kFitError = 3e-6;
    for (double x = 0.0; x < 20.0; x += 0.01) {
        const long double l = static_cast<long double>(real(x));
        long double expected = 1.0L / std::sqrt(std::numbers::pi_v<long double>);
        if (x < 6.0) {
            expected -= l * std::exp(l * l) * std::erfc(l);
        } else {  // asymptotic series: the definition would subtract 1 from 1
            long double term = 1.0L;
            long double sum = 0.0L;
            for (int k = 1; k < 10; ++k) sum -= (term *= -(2 * k - 1) / (2 * l * l));
            expected *= sum;
        }
        const double value = static_cast<double>(shader::lq_scaled_ierfc(real(x)));
        EXPECT_NEAR(value / static_cast<double>(expected), 1.0, kFitError + roundings(16)) << x;
    }
}

TEST(Math, SineFromCosineKeepsDigitsNearOne) {
    for (double theta = 1e-3; theta < kPi / 2; theta *= 1.3) {
        const Real cosine = real(std::cos(theta));
        const double exact =
            std::sqrt((1 - static_cast<double>(cosine)) * (1 + static_cast<double>(cosine)));
        EXPECT_NEAR(static_cast<double>(shader::lq_sine_from_cosine(cosine)), exact,
                    exact * roundings(4));
    }
    EXPECT_EQ(shader::lq_sine_from_cosine(real(1.0)), real(0.0));
}

TEST(Math, SafeSqrtOfRoundingNoiseIsZero) {
    EXPECT_EQ(shader::lq_safe_sqrt(real(-1e-9)), real(0.0));
    EXPECT_EQ(shader::lq_safe_sqrt(real(4.0)), real(2.0));
}

class FrameTest : public testing::TestWithParam<glm::dvec3> {};

TEST_P(FrameTest, IsRightHandedOrthonormalAndInvertible) {
    const glm::dvec3 n = glm::normalize(GetParam());
    const vec3 normal{real(n.x), real(n.y), real(n.z)};
    const vec3 along = direction(0.7, 1.9);
    for (const shader::LqFrame& frame :
         {shader::lq_frame_from_normal(normal), shader::lq_frame_from_tangent(normal, along)}) {
        const glm::dvec3 t = widen(frame.tangent);
        const glm::dvec3 b = widen(frame.bitangent);
        const double tolerance = roundings(16);
        EXPECT_NEAR(glm::dot(t, t), 1.0, tolerance);
        EXPECT_NEAR(glm::dot(t, b), 0.0, tolerance);
        EXPECT_NEAR(glm::dot(glm::cross(t, b), widen(frame.normal)), 1.0, tolerance);
        const vec3 w = direction(1.1, -2.3);
        const vec3 back = shader::lq_frame_to_world(frame, shader::lq_frame_to_local(frame, w));
        EXPECT_LT(glm::length(widen(back) - widen(w)), tolerance);
        EXPECT_NEAR(static_cast<double>(shader::lq_frame_to_local(frame, normal).z), 1.0,
                    tolerance);
    }
}

INSTANTIATE_TEST_SUITE_P(Normals, FrameTest,
                         testing::Values(glm::dvec3{0, 0, 1}, glm::dvec3{0, 0, -1},
                                         glm::dvec3{1, 0, 0}, glm::dvec3{0.3, -0.5, 0.2},
                                         glm::dvec3{1e-4, 1e-4, -1}, glm::dvec3{-1, 2, -1e-6}));

TEST(Frame, ATangentParallelToTheNormalStillGivesAFrame) {
    const vec3 normal = direction(0.4, 0.3);
    const shader::LqFrame frame = shader::lq_frame_from_tangent(normal, normal);
    EXPECT_NEAR(glm::length(widen(frame.tangent)), 1.0, roundings(16));
}

TEST(Frame, OnlyUnitDirectionsInTheUpperHemisphereAreAbove) {
    EXPECT_TRUE(shader::lq_is_above(direction(1.5, 0.0)));
    EXPECT_FALSE(shader::lq_is_above(direction(1.6, 0.0)));
    EXPECT_FALSE(shader::lq_is_above(vec3(real(1.0), real(0.0), real(0.0))));
    EXPECT_FALSE(shader::lq_is_above(vec3(real(0.0), real(0.0), real(1e30))));
}

TEST(Random, UniformsAreInRangeAndStreamsDiffer) {
    std::set<std::uint32_t> seen;
    double sum = 0.0;
    double product = 0.0;
    constexpr int kCount = 1 << 16;
    for (unsigned i = 0; i < kCount; ++i) {
        const shader::vec4 u = shader::lq_random_uniforms(glm::uvec4(i, 7u, 0u, 0u));
        EXPECT_GE(u.x, real(0.0));
        EXPECT_LT(u.x, real(1.0));
        sum += static_cast<double>(u.y);
        product += (static_cast<double>(u.x) - 0.5) * (static_cast<double>(u.w) - 0.5);
        seen.insert(shader::lq_random_bits(glm::uvec4(i, 7u, 0u, 0u)).z);
    }
    // Four standard errors of the mean of uniforms and of the product of independent ones.
    EXPECT_NEAR(sum / kCount, 0.5, 4.0 * std::sqrt(1.0 / 12 / kCount));
    EXPECT_NEAR(product / kCount, 0.0, 4.0 / 12 / std::sqrt(kCount));
    EXPECT_GT(seen.size(), kCount - 10u);  // birthday bound: 0.5 collisions expected
    EXPECT_NE(shader::lq_random_bits(glm::uvec4(1u, 0u, 0u, 0u)),
              shader::lq_random_bits(glm::uvec4(0u, 1u, 0u, 0u)));
}

TEST(Random, FollowsThePublishedPcgRecurrence) {
    // Jarzynski and Olano 2020, listing of pcg4d, evaluated in 64 bits and reduced.
    const auto pcg = [](std::uint64_t x, std::uint64_t y, std::uint64_t z, std::uint64_t w) {
        const std::uint64_t mask = 0xffffffffu;
        const auto mad = [mask](std::uint64_t a, std::uint64_t b, std::uint64_t c) {
            return (a + b * c) & mask;
        };
        for (std::uint64_t* v : {&x, &y, &z, &w}) *v = mad(1013904223u, *v, 1664525u);
        for (int round = 0; round < 2; ++round) {
            x = mad(x, y, w);
            y = mad(y, z, x);
            z = mad(z, x, y);
            w = mad(w, y, z);
            if (round == 0)
                for (std::uint64_t* v : {&x, &y, &z, &w}) *v ^= *v >> 16;
        }
        return glm::uvec4(x, y, z, w);
    };
    EXPECT_EQ(shader::lq_random_bits(glm::uvec4(3u, 1u, 4u, 1u)), pcg(3, 1, 4, 1));
    EXPECT_EQ(shader::lq_random_bits(glm::uvec4(0xfffffff0u, 0u, 9u, 77u)),
              pcg(0xfffffff0u, 0, 9, 77));
}

TEST(Sampling, CosineHemisphereHasTheMomentsOfItsDensity) {
    // E[cos^n] under cos / pi is 2 / (n + 2); the points' discrepancy is below 20 / count.
    constexpr int kCount = 4096;
    double first = 0.0;
    double second = 0.0;
    for (unsigned i = 0; i < kCount; ++i) {
        const vec3 w = shader::lq_sample_cosine_hemisphere(shader::lq_low_discrepancy_point(i));
        EXPECT_NEAR(glm::length(widen(w)), 1.0, 1e-7 + roundings(8));
        first += static_cast<double>(w.z);
        second += static_cast<double>(w.z * w.z);
    }
    EXPECT_NEAR(first / kCount, 2.0 / 3, 20.0 / kCount);
    EXPECT_NEAR(second / kCount, 0.5, 20.0 / kCount);
    EXPECT_NEAR(static_cast<double>(shader::lq_cosine_hemisphere_pdf(real(0.5))), 0.5 / kPi,
                roundings(2));
    EXPECT_EQ(shader::lq_cosine_hemisphere_pdf(real(-0.5)), real(0.0));
}

TEST(Sampling, LowDiscrepancyPointsBeatRandomOnes) {
    // Error of the area of a quarter disk: random points would be off by 0.4 / sqrt(n) = 0.004.
    constexpr int kCount = 10000;
    int inside = 0;
    for (unsigned i = 0; i < kCount; ++i) {
        const vec2 p = shader::lq_low_discrepancy_point(i);
        inside += p.x * p.x + p.y * p.y < real(1.0) ? 1 : 0;
    }
    EXPECT_NEAR(static_cast<double>(inside) / kCount, kPi / 4, 0.001);
}

TEST(ToneMapping, DisplayColorMatchesTheSrgbStandard) {
    // IEC 61966-2-1: linear 0.0031308 encodes to 0.04045, 1 to 1, 0.2140 to 0.5.
    constexpr double kPublishedDigits = 5e-5;
    EXPECT_NEAR(static_cast<double>(shader::lq_srgb_encode(real(0.0031308))), 0.04045,
                kPublishedDigits);
    EXPECT_NEAR(static_cast<double>(shader::lq_srgb_encode(real(1.0))), 1.0, roundings(8));
    EXPECT_NEAR(static_cast<double>(shader::lq_srgb_encode(real(0.2140411))), 0.5,
                kPublishedDigits);
    EXPECT_NEAR(static_cast<double>(shader::lq_tone_curve(real(1.0))), 1 - std::exp(-1.0),
                roundings(4));
    const vec3 color = shader::lq_display_color(vec3(real(0.0), real(1.0), real(1e9)));
    EXPECT_EQ(color.x, real(0.0));
    EXPECT_LE(color.z, real(1.0 + roundings(8)));
    EXPECT_GT(color.z, color.y);
}

}  // namespace
}  // namespace lacquer::shader_test
