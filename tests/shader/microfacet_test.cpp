// Facet distributions of the shader source against the properties that define them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "shader/shader.h"
#include "support/chi_square.h"
#include "support/expect_fit.h"
#include "support/quadrature.h"

namespace lacquer::shader_test {
namespace {

constexpr double kPi = std::numbers::pi;

struct FacetsCase {
    int ndf;
    double alpha_x, alpha_y;
};

class FacetsTest : public testing::TestWithParam<FacetsCase> {
 protected:
    shader::LqFacets facets() const {
        return shader::lq_facets_prepare(GetParam().ndf, real(GetParam().alpha_x),
                                         real(GetParam().alpha_y));
    }

    double density(const glm::dvec3& wm) const {
        return static_cast<double>(
            shader::lq_facets_density(facets(), vec3(real(wm.x), real(wm.y), real(wm.z))));
    }
};

// Midpoint error at this many steps, found by doubling them in double precision, plus float noise.
constexpr int kSteps = 512;
constexpr double kQuadratureError = 2e-4;

TEST_P(FacetsTest, ProjectedAreaOfAllFacetsIsOne) {
    const double area = test::integrate_hemisphere(
        [&](const glm::dvec3& wm) { return density(wm) * wm.z; }, kSteps);
    EXPECT_NEAR(area, 1.0, kQuadratureError);
}

TEST_P(FacetsTest, FacetsVisibleFromAnyDirectionShowItsProjectedArea) {
    // Smith's condition (Heitz 2014, Eq. 28), which Lambda follows from: the facets that face w,
    // times those of them not hidden, show exactly cos_theta of area.
    for (const double theta : {0.0, 0.5, 1.0, 1.4, 1.55})
        for (const double phi : {0.0 * kPi, 0.25 * kPi, 0.5 * kPi}) {
            const vec3 w = direction(theta, phi);
            const double facing = test::integrate_hemisphere(
                [&](const glm::dvec3& wm) {
                    return density(wm) * std::max<double>(0.0, glm::dot(widen(w), wm));
                },
                kSteps);
            const double masking = static_cast<double>(shader::lq_facets_masking(facets(), w));
            EXPECT_NEAR(facing * masking, static_cast<double>(w.z), 2 * kQuadratureError)
                << theta << " " << phi;
        }
}

TEST_P(FacetsTest, MaskingShadowingIsBelowEitherMaskingAndSymmetric) {
    const shader::LqFacets f = facets();
    for (const double theta : {0.0, 0.7, 1.3, 1.56}) {
        const vec3 wi = direction(theta, 0.3);
        const vec3 wo = direction(1.1, 2.0);
        const Real both = shader::lq_facets_masking_shadowing(f, wi, wo);
        EXPECT_LE(both, shader::lq_facets_masking(f, wi) * real(1.0 + roundings(4)));
        EXPECT_LE(both, shader::lq_facets_masking(f, wo) * real(1.0 + roundings(4)));
        EXPECT_NEAR(static_cast<double>(both),
                    static_cast<double>(shader::lq_facets_masking_shadowing(f, wo, wi)),
                    roundings(4));
        // Heitz 2014, Eq. 99 from the two maskings: 1 / G2 = 1 / G1(wi) + 1 / G1(wo) - 1.
        const double i = static_cast<double>(shader::lq_facets_masking(f, wi));
        const double o = static_cast<double>(shader::lq_facets_masking(f, wo));
        EXPECT_NEAR(static_cast<double>(both), 1.0 / (1.0 / i + 1.0 / o - 1.0), roundings(16));
    }
}

TEST_P(FacetsTest, VisibleNormalsFollowTheirDensity) {
    constexpr int kRows = 24;
    constexpr int kColumns = 32;
    constexpr int kSamples = 1 << 17;
    constexpr int kSub = 12;  // midpoints per cell side for the expectation
    constexpr double kViews[] = {0.1, 0.9, 1.45};
    const double significance = test::sidak_significance(0.01, 3 * 10);
    const shader::LqFacets f = facets();
    for (const double view : kViews) {
        const vec3 w = direction(view, 0.6);
        // Cells uniform in phi and in q = 1 - 1 / sqrt(1 + s^2), s the slope over alpha: narrow
        // lobes fill them, and the visible density, which grows like s, stays bounded in q.
        const auto row_of = [&](const glm::dvec3& wm) {
            const double x = wm.x / static_cast<double>(f.alpha_x) / wm.z;
            const double y = wm.y / static_cast<double>(f.alpha_y) / wm.z;
            const double squared = x * x + y * y;
            return 1.0 - std::sqrt(1.0 / (1.0 + squared));
        };
        const auto column_of = [&](const glm::dvec3& wm) {
            const double turn = std::atan2(wm.y / static_cast<double>(f.alpha_y),
                                           wm.x / static_cast<double>(f.alpha_x)) /
                                (2 * kPi);
            return turn < 0.0 ? turn + 1.0 : turn;
        };
        std::vector<double> observed(kRows * kColumns, 0.0);
        for (unsigned i = 0; i < kSamples; ++i) {
            const shader::vec4 u = shader::lq_random_uniforms(glm::uvec4(i, 1u, 2u, 3u));
            const glm::dvec3 wm =
                widen(shader::lq_facets_sample_visible_normal(f, w, vec2(u.x, u.y)));
            ASSERT_GT(wm.z, 0.0);
            ASSERT_NEAR(glm::length(wm), 1.0, roundings(16));
            const int row = std::min(static_cast<int>(row_of(wm) * kRows), kRows - 1);
            const int column = std::min(static_cast<int>(column_of(wm) * kColumns), kColumns - 1);
            observed[static_cast<std::size_t>(row * kColumns + column)] += 1.0;
        }
        // Expectation: the visible density in slopes, d omega = cos^3 d slope_x d slope_y, where
        // d slope_x d slope_y = alpha_x alpha_y s ds dphi = alpha_x alpha_y dq / (1 - q)^3 dphi.
        std::vector<double> expected(kRows * kColumns, 0.0);
        const double masking = static_cast<double>(shader::lq_facets_masking(f, w));
        for (int row = 0; row < kRows * kSub; ++row)
            for (int column = 0; column < kColumns * kSub; ++column) {
                const double rest = 1.0 - (row + 0.5) / (kRows * kSub);  // 1 - q
                const double phi = 2 * kPi * (column + 0.5) / (kColumns * kSub);
                const double radius = std::sqrt(1.0 - rest * rest) / rest;
                const double ax = static_cast<double>(f.alpha_x);
                const double ay = static_cast<double>(f.alpha_y);
                const glm::dvec3 wm = glm::normalize(
                    glm::dvec3{ax * radius * std::cos(phi), ay * radius * std::sin(phi), 1.0});
                const double area =
                    ax * ay / (rest * rest * rest) * 2 * kPi / (kRows * kSub) / (kColumns * kSub);
                const double visible = density(wm) * std::max<double>(0.0, glm::dot(widen(w), wm)) *
                                       masking / static_cast<double>(w.z);
                expected[static_cast<std::size_t>(row / kSub * kColumns + column / kSub)] +=
                    kSamples * visible * wm.z * wm.z * wm.z * area;
            }
        test::expect_fit(observed, expected, significance, "view " + std::to_string(view));
    }
}

std::string case_name(const testing::TestParamInfo<FacetsCase>& info) {
    const auto digits = [](double alpha) {
        return std::to_string(static_cast<int>(std::lround(1000 * alpha)));
    };
    return (info.param.ndf == 0 ? "ggx_" : "beckmann_") + digits(info.param.alpha_x) + "_" +
           digits(info.param.alpha_y);
}

INSTANTIATE_TEST_SUITE_P(Cases, FacetsTest,
                         testing::Values(FacetsCase{0, 0.1, 0.1}, FacetsCase{0, 0.5, 0.5},
                                         FacetsCase{0, 1.0, 1.0}, FacetsCase{0, 0.1, 0.4},
                                         FacetsCase{0, 0.8, 0.2}, FacetsCase{1, 0.1, 0.1},
                                         FacetsCase{1, 0.5, 0.5}, FacetsCase{1, 1.0, 1.0},
                                         FacetsCase{1, 0.1, 0.4}, FacetsCase{1, 0.8, 0.2}),
                         case_name);

TEST(Facets, PrepareKeepsAlphaInItsRange) {
    const shader::LqFacets facets = shader::lq_facets_prepare(0, real(0.0), real(7.0));
    EXPECT_EQ(facets.alpha_x, shader::LQ_MIN_ALPHA);
    EXPECT_EQ(facets.alpha_y, real(1.0));
}

TEST(Beckmann, LambdaMatchesHeitzEquationEightyThree) {
    for (const double alpha : {0.05, 0.3, 1.0})
        for (const double theta : {0.3, 0.9, 1.3, 1.55}) {
            const double a = 1.0 / (alpha * std::tan(theta));
            const double lambda =
                (std::erf(a) - 1.0) / 2.0 + std::exp(-a * a) / (2.0 * a * std::sqrt(kPi));
            const double value = static_cast<double>(shader::lq_beckmann_projected_lambda(
                direction(theta, 1.0), real(alpha), real(alpha)));
            // The fit of ierfc is good to 3e-6 of a value of at most 0.3.
            EXPECT_NEAR(value, lambda * std::cos(theta), 1e-6 + roundings(16));
        }
}

TEST(Beckmann, HalfErfcAndItsInverseMatchTheStandardLibrary) {
    constexpr double kFitError = 2e-6;      // of lq_scaled_ierfc, amplified at 0.5
    constexpr double kInverseError = 4e-6;  // Giles 2012, single precision, and the log before it
    for (double x = -4.0; x <= 4.0; x += 0.05) {
        EXPECT_NEAR(static_cast<double>(shader::lq_half_erfc(real(x))), 0.5 * std::erfc(x),
                    kFitError);
        const double y = std::erf(x / 2);
        EXPECT_NEAR(static_cast<double>(shader::lq_erf_inverse(real(y))), x / 2,
                    kInverseError + roundings(8) * std::exp(x * x / 4));
    }
}

}  // namespace
}  // namespace lacquer::shader_test
