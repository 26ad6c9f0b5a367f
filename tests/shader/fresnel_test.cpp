// Fresnel reflectance of the shader source against the textbook's complex amplitudes.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "shader/shader.h"

namespace lacquer::shader_test {
namespace {

// Born and Wolf 1999, Eqs. 1.5.21 and 14.2: amplitudes with a complex refracted cosine, in long
// double so that their cancellations do not matter.
double textbook_reflectance(double cosine, double eta, double kappa) {
    using Complex = std::complex<long double>;
    const Complex index(eta, kappa);
    const long double c = cosine;
    const Complex cos_t = std::sqrt(Complex(1.0L) - (1.0L - c * c) / (index * index));
    const Complex s = (c - index * cos_t) / (c + index * cos_t);
    const Complex p = (index * c - cos_t) / (index * c + cos_t);
    return static_cast<double>(0.5L * (std::norm(s) + std::norm(p)));
}

constexpr double kCosines[] = {1.0, 0.99, 0.9, 0.7, 0.5, 0.3, 0.1, 0.02, 0.001};

TEST(FresnelDielectric, MatchesTheTextbookToRounding) {
    for (const double eta : {1.0 / 3, 0.6, 0.8, 1.001, 1.33, 1.5, 2.0, 3.0})
        for (const double cosine : kCosines) {
            const Real c = real(cosine);
            const Real e = real(eta);
            const double expected =
                textbook_reflectance(static_cast<double>(c), static_cast<double>(e), 0.0);
            const double value = static_cast<double>(shader::lq_fresnel_dielectric(c, e));
            // Rounding of g^2 grows by 1 / g towards the critical angle; these cosines keep away.
            EXPECT_NEAR(value, expected, expected * roundings(64)) << eta << " " << cosine;
        }
}

TEST(FresnelDielectric, AtNormalIncidenceIsTheSquaredContrast) {
    EXPECT_NEAR(static_cast<double>(shader::lq_fresnel_dielectric(real(1.0), real(1.5))), 0.04,
                roundings(4));
}

TEST(FresnelDielectric, IsTotalBeyondTheCriticalAngle) {
    const double critical = std::sqrt(1 - 0.64);
    EXPECT_EQ(shader::lq_fresnel_dielectric(real(critical - 1e-4), real(0.8)), real(1.0));
    EXPECT_LT(shader::lq_fresnel_dielectric(real(critical + 1e-4), real(0.8)), real(1.0));
}

TEST(FresnelDielectric, ReadsTheSameFromBothSides) {
    for (const double cosine : {1.0, 0.8, 0.4, 0.1}) {
        const double cos_t = std::sqrt(1 - (1 - cosine * cosine) / 2.25);
        EXPECT_NEAR(static_cast<double>(shader::lq_fresnel_dielectric(real(cosine), real(1.5))),
                    static_cast<double>(shader::lq_fresnel_dielectric(real(cos_t), real(1 / 1.5))),
                    roundings(64));
    }
}

TEST(FresnelDielectric, VanishesWithoutContrast) {
    for (const double cosine : kCosines)
        EXPECT_EQ(shader::lq_fresnel_dielectric(real(cosine), real(1.0)), real(0.0));
}

TEST(FresnelConductor, MatchesTheTextbookToRounding) {
    const double indices[][2] = {{0.143, 3.983}, {1.442, 1.603}, {9.0, 0.1}, {0.05, 10.0},
                                 {1.0, 0.01},    {2.9, 3.1},     {0.5, 0.0}, {1.5, 0.0}};
    for (const auto& index : indices)
        for (const double cosine : kCosines) {
            const Real c = real(cosine);
            const Real eta = real(index[0]);
            const Real kappa = real(index[1]);
            const double expected = textbook_reflectance(
                static_cast<double>(c), static_cast<double>(eta), static_cast<double>(kappa));
            const double value = static_cast<double>(shader::lq_fresnel_conductor(c, eta, kappa));
            EXPECT_NEAR(value, expected, roundings(64)) << index[0] << " " << cosine;
        }
}

TEST(FresnelConductor, KeepsItsDigitsAtGrazingForAnIndexNearTheExteriors) {
    for (const double eta : {0.999, 1.0005, 1.01})
        for (const double kappa : {0.0, 1e-4, 1e-2})
            for (const double cosine : {0.1, 0.01, 0.003}) {
                const Real c = real(cosine);
                const Real e = real(eta);
                const Real k = real(kappa);
                // The critical angle of 0.999 is at 0.0447: these cosines keep away from it.
                const double expected = textbook_reflectance(
                    static_cast<double>(c), static_cast<double>(e), static_cast<double>(k));
                const double value = static_cast<double>(shader::lq_fresnel_conductor(c, e, k));
                EXPECT_NEAR(value, expected, 1e-4 * expected + roundings(8))
                    << eta << " " << kappa << " " << cosine;
            }
}

TEST(FresnelConductor, WithoutAbsorptionIsADielectric) {
    for (const double cosine : kCosines)
        EXPECT_NEAR(
            static_cast<double>(shader::lq_fresnel_conductor(real(cosine), real(1.5), real(0.0))),
            static_cast<double>(shader::lq_fresnel_dielectric(real(cosine), real(1.5))),
            roundings(64));
}

TEST(FresnelConductor, RgbAppliesEachIndexToItsChannel) {
    const vec3 eta{real(0.143), real(0.375), real(1.442)};
    const vec3 kappa{real(3.983), real(2.386), real(1.603)};
    const vec3 rgb = shader::lq_fresnel_conductor_rgb(real(0.6), eta, kappa);
    EXPECT_EQ(rgb.x, shader::lq_fresnel_conductor(real(0.6), eta.x, kappa.x));
    EXPECT_EQ(rgb.y, shader::lq_fresnel_conductor(real(0.6), eta.y, kappa.y));
    EXPECT_EQ(rgb.z, shader::lq_fresnel_conductor(real(0.6), eta.z, kappa.z));
    EXPECT_GT(rgb.x, rgb.z);  // gold is red
}

TEST(FresnelConductor, StaysFiniteAtEveryCorner) {
    for (const double eta : {0.0, 1e-30, 1.0, 40.0})
        for (const double kappa : {0.0, 1e-30, 1.0, 40.0})
            for (const double cosine : {0.0, 1e-38, 1e-6, 1.0, 1.0000001, -0.5}) {
                const Real f = shader::lq_fresnel_conductor(real(cosine), real(eta), real(kappa));
                EXPECT_TRUE(f >= real(0.0) && f <= real(1.0))
                    << eta << " " << kappa << " " << cosine << " " << f;
            }
}

}  // namespace
}  // namespace lacquer::shader_test
