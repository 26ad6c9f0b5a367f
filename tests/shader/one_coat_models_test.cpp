// The levels of one coat beside `plain`: what holds for any input, and what they share.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "shader/shader.h"

namespace lacquer::shader_test {
namespace {

using shader::LqAlbedo;
using shader::LqFacets;
using shader::LqOneCoat;
using shader::LqSample;

// The functions of one level over a surface that it prepared.
template <auto Prepare, auto EvalCos, auto Pdf, auto Sample, auto Albedo>
struct Level {
    explicit Level(const LqOneCoat& surface) : prepared{Prepare(surface)} {}
    vec3 eval_cos(const vec3& wi, const vec3& wo) const { return EvalCos(prepared, wi, wo); }
    Real pdf(const vec3& wi, const vec3& wo) const { return Pdf(prepared, wi, wo); }
    LqSample sample(const vec3& wo, const vec3& u) const { return Sample(prepared, wo, u); }
    LqAlbedo albedo(const vec3& wo, int count) const { return Albedo(prepared, wo, count); }
    decltype(Prepare(LqOneCoat{})) prepared;
};

using Clearcoat =
    Level<shader::lq_clearcoat_prepare, shader::lq_clearcoat_eval_cos, shader::lq_clearcoat_pdf,
          shader::lq_clearcoat_sample, shader::lq_clearcoat_albedo>;
using WeidlichWilkie = Level<shader::lq_weidlich_wilkie_prepare,
                             shader::lq_weidlich_wilkie_eval_cos, shader::lq_weidlich_wilkie_pdf,
                             shader::lq_weidlich_wilkie_sample, shader::lq_weidlich_wilkie_albedo>;
using OpenpbrCoat = Level<shader::lq_openpbr_coat_prepare, shader::lq_openpbr_coat_eval_cos,
                          shader::lq_openpbr_coat_pdf, shader::lq_openpbr_coat_sample,
                          shader::lq_openpbr_coat_albedo>;

template <typename T>
class OneCoatLevel : public ::testing::Test {};
using Levels = ::testing::Types<Clearcoat, WeidlichWilkie, OpenpbrCoat>;
TYPED_TEST_SUITE(OneCoatLevel, Levels);

LqOneCoat glaze(double alpha, double eta, int base) {
    const LqFacets facets{shader::LQ_NDF_GGX, real(alpha), real(alpha)};
    return {facets,
            real(eta),
            vec3(real(0.1), real(0.7), real(2.3)),
            base,
            vec3(real(0.8), real(0.5), real(0.2)),
            facets,
            vec3(real(0.143), real(0.375), real(1.442)),
            vec3(real(3.983), real(2.386), real(1.603))};
}

bool is_sound(Real value) {
    return value >= real(0.0) && value <= std::numeric_limits<Real>::max();
}

bool is_sound(const vec3& v) {
    return is_sound(v.x) && is_sound(v.y) && is_sound(v.z);
}

TYPED_TEST(OneCoatLevel, SampleWeightIsEvalCosOverPdf) {
    for (const int base : {shader::LQ_BASE_LAMBERTIAN, shader::LQ_BASE_CONDUCTOR}) {
        const TypeParam level{glaze(0.3, 1.5, base)};
        for (unsigned i = 0; i < 1000; ++i) {
            const shader::vec4 u = shader::lq_random_uniforms(glm::uvec4(i, 9u, 0u, 0u));
            const vec3 wo = direction(1.5 * static_cast<double>(u.w), 0.7);
            const LqSample chosen = level.sample(wo, vec3(u.x, u.y, u.z));
            EXPECT_EQ(chosen.pdf, level.pdf(chosen.wi, wo));
            const double f = static_cast<double>(level.eval_cos(chosen.wi, wo).x);
            EXPECT_NEAR(static_cast<double>(chosen.weight.x * chosen.pdf), f, f * roundings(8));
        }
    }
}

// The mean weight of an independent sequence of samples, in the same precision.
TYPED_TEST(OneCoatLevel, AlbedoIsTheMeanWeight) {
    constexpr int kPoints = 4096;
    constexpr double kPointError = 2e-3;  // of 4096 low-discrepancy points, by doubling them
    constexpr unsigned kSamples = 1u << 15;
    for (const int base : {shader::LQ_BASE_LAMBERTIAN, shader::LQ_BASE_CONDUCTOR})
        for (const double eta : {0.0, 0.7, 1.5}) {
            const TypeParam level{glaze(0.3, eta, base)};
            const vec3 wo = direction(0.8, 1.0);
            double sum = 0.0;
            double squares = 0.0;
            for (unsigned i = 0; i < kSamples; ++i) {
                const shader::vec4 u = shader::lq_random_uniforms(glm::uvec4(i, 3u, 0u, 0u));
                const auto weight =
                    static_cast<double>(level.sample(wo, vec3(u.x, u.y, u.z)).weight.y);
                sum += weight;
                squares += weight * weight;
            }
            const double mean = sum / kSamples;
            const double deviation =
                std::sqrt(std::max<double>(0.0, squares / kSamples - mean * mean));
            const LqAlbedo albedo = level.albedo(wo, kPoints);
            EXPECT_NEAR(static_cast<double>(albedo.direct.y + albedo.base.y), mean,
                        4 * deviation / std::sqrt(kSamples) + kPointError)
                << "base " << base << " eta " << eta;
        }
}

TYPED_TEST(OneCoatLevel, IsFiniteAndNonNegativeForAnyFiniteInput) {
    const double values[] = {0.0, -0.0, 1e-38, 1e-12, 1e-4, 0.6, 1.0, -1.0, 1e4, 1e38};
    std::vector<vec3> directions;
    for (const double x : values)
        for (const double z : values) directions.emplace_back(real(x), real(0.0), real(z));
    for (const double x : {1e-20, 0.70710678, 1.0})
        directions.emplace_back(real(x), real(-x), real(x));
    for (const double alpha : {0.0, 1e-3, 1.0, 1e30, -5.0})
        for (const double eta : {0.0, 1e-20, 0.5, 1.0, 3.0, 1e30})
            for (const int base : {0, 1, 2, 99}) {
                const LqFacets facets{base % 2, real(alpha), real(alpha / 2)};
                const TypeParam level{{facets, real(eta), vec3(real(alpha)), base, vec3(real(eta)),
                                       facets, vec3(real(eta)), vec3(real(alpha))}};
                for (const vec3& wo : directions) {
                    for (const vec3& wi : directions)
                        ASSERT_TRUE(is_sound(level.eval_cos(wi, wo)) && is_sound(level.pdf(wi, wo)))
                            << alpha << " " << eta << " " << base << " wi " << wi.x << " " << wi.z
                            << " wo " << wo.x << " " << wo.z;
                    const LqSample chosen = level.sample(wo, vec3(real(0.3), real(0.9), real(0.5)));
                    const LqAlbedo albedo = level.albedo(wo, 4);
                    ASSERT_TRUE(is_sound(chosen.weight) && is_sound(chosen.pdf) &&
                                is_sound(albedo.direct) && is_sound(albedo.base))
                        << alpha << " " << eta << " " << base << " wo " << wo.x << " " << wo.z;
                }
            }
}

// Born and Wolf 1999, section 1.5: what is not reflected is transmitted, and a refracted cosine
// obeys Snell's law.
TEST(Transmittance, IsWhatIsNotReflected) {
    for (const double eta : {0.4, 0.9, 1.0, 1.5, 3.0})
        for (const double cosine : {1.0, 0.9, 0.5, 0.05, 1e-4}) {
            const Real c = real(cosine);
            EXPECT_NEAR(static_cast<double>(shader::lq_transmittance_dielectric(c, real(eta)) +
                                            shader::lq_fresnel_dielectric(c, real(eta))),
                        1.0, roundings(16))
                << eta << " " << cosine;
            const double squared = 1 - (1 - cosine * cosine) / (eta * eta);
            const auto refracted = static_cast<double>(shader::lq_refracted_cosine(c, real(eta)));
            EXPECT_NEAR(refracted * refracted, std::max<double>(squared, 0.0), roundings(32))
                << eta;
        }
    EXPECT_EQ(shader::lq_transmittance_dielectric(real(0.5), real(0.5)), real(0.0));
}

// The series of the specification's logarithm.
TEST(OpenpbrCoat, AverageFresnelIsTheSpecifiedFit) {
    for (const double eta : {1.0, 1.1, 1.5, 2.0, 3.0})
        EXPECT_NEAR(static_cast<double>(shader::lq_openpbr_average_fresnel(real(eta))),
                    std::log((10893 * eta - 1438.2) / (-774.4 * eta * eta + 10212 * eta + 1)),
                    1e-9 + roundings(4))
            << eta;
}

}  // namespace
}  // namespace lacquer::shader_test
