// The published operators at values that their equations give by hand.
#include "reference/stack/published/operators_2018.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reference/stack/equivalent_lobe_alpha.h"
#include "reference/stack/layers.h"
#include "reference/stack/scattering.h"

namespace lacquer {
namespace {

namespace published = reference::published_2018;

constexpr double kRounding = 1e-12;

// Eq. 6: alpha^1.1 = 1/2 has f = 1, alpha^1.1 = 1/3 has f = 1/2.
TEST(Published2018, VarianceOfAlpha) {
    EXPECT_NEAR(published::variance_of_alpha(std::pow(0.5, 1.0 / 1.1)), 1.0, kRounding);
    EXPECT_NEAR(published::variance_of_alpha(std::pow(1.0 / 3.0, 1.0 / 1.1)), 0.5, kRounding);
    EXPECT_EQ(published::variance_of_alpha(0.0), 0.0);
    EXPECT_TRUE(std::isfinite(published::variance_of_alpha(1.0)));
}

TEST(Published2018, AlphaOfVarianceIsTheInverse) {
    EXPECT_EQ(published::alpha_of_variance(0.0), 0.0);
    for (const double alpha : {0.01, 0.1, 0.5, 0.9})
        EXPECT_NEAR(published::alpha_of_variance(published::variance_of_alpha(alpha)), alpha,
                    kRounding);
}

// Eq. 12: sin_theta 0.6 into index 1.5 is 0.4; from glass, none beyond the critical angle.
TEST(Published2018, MeanIsRefracted) {
    EXPECT_NEAR(published::refracted_sine(0.6, 1.5), 0.4, kRounding);
    EXPECT_NEAR(published::refracted_sine(0.4, 1.0 / 1.5), 0.6, kRounding);
    EXPECT_EQ(published::refracted_sine(0.9, 1.0 / 1.5), 1.0);
}

// Eq. 10, eta_12 = 2/3 along the normal: (1 - 2/3) / 2 and, as printed, (1 + 2/3) / 2. At cosines
// 0.6 and 0.8 into index 1.5, eta_12 cos_theta_i / cos_theta_t = 1/2.
TEST(Published2018, TransmittedRoughness) {
    EXPECT_NEAR(published::refraction_scale(1.0, 1.0, 1.5), 1.0 / 6.0, kRounding);
    EXPECT_NEAR(published::refraction_scale_as_printed(1.0, 1.0, 1.5), 5.0 / 6.0, kRounding);
    EXPECT_NEAR(published::refraction_scale(0.6, 0.8, 1.5), 0.25, kRounding);
    EXPECT_NEAR(published::refraction_scale_as_printed(0.6, 0.8, 1.5), 0.75, kRounding);
    EXPECT_NEAR(published::refraction_scale(1.0, 1.0, 0.5), 0.5, kRounding);
    EXPECT_NEAR(published::refraction_scale(0.7, 0.7, 1.0), 0.0, kRounding);
}

// Walter et al. 2007, Eqs. 20 and 21 along the normal, where both facets' density is 1 / (pi
// alpha^2): the refraction's peak is eta_2^2 / (eta_1 - eta_2)^2 of it, the reflection's 1/4.
TEST(Published2018, EqualPeaks) {
    for (const double eta : {0.5, 0.8, 1.5, 2.0}) {
        const double refracted = eta * eta / ((1.0 - eta) * (1.0 - eta));
        const double scale = published::peak_scale(eta);
        EXPECT_NEAR(0.25 / (scale * scale), refracted, 1e-9 * refracted);
    }
}

// Eq. 13, a variance of 0.3 into index 1.5.
TEST(Published2018, VarianceIsScaled) {
    EXPECT_NEAR(published::refracted_variance_as_printed(0.3, 1.5), 0.45, kRounding);
    EXPECT_NEAR(published::refracted_variance(0.3, 1.5), 0.2, kRounding);
}

// Eq. 21 at g = 1/2: 1^0.8 / 1.5. Eq. 22 at depth 1 and cosine 1/2: 2 exp(-2).
TEST(Published2018, Scattering) {
    EXPECT_NEAR(reference::scattering_variance_2018(0.5), 1.0 / 1.5, kRounding);
    EXPECT_NEAR(reference::scattering_variance_2018(1.0), 0.0, kRounding);
    const auto light = reference::slab_light_2018({0.0, 1.0, 0.7}, 0.5);
    EXPECT_NEAR(light.unscattered, std::exp(-2.0), kRounding);
    EXPECT_NEAR(light.scattered, 2.0 * std::exp(-2.0), kRounding);
    EXPECT_EQ(light.back, 0.0);
}

TEST(EquivalentLobeAlpha, OfGgxIsItsOwn) {
    for (const double alpha : {0.0, 0.001, 0.3, 0.7, 1.0})
        EXPECT_EQ(reference::equivalent_lobe_alpha({Ndf::ggx, {alpha, alpha}}), alpha);
    EXPECT_DOUBLE_EQ(reference::equivalent_lobe_alpha({Ndf::ggx, {0.2, 0.6}}), 0.4);
}

TEST(EquivalentLobeAlpha, OfBeckmannGrowsAndIsLess) {
    double before = -1.0;
    for (int n = 0; n <= 20; ++n) {
        const double alpha = n / 20.0;
        const double lobe = reference::equivalent_lobe_alpha({Ndf::beckmann, {alpha, alpha}});
        EXPECT_GT(lobe, before);
        EXPECT_LE(lobe, alpha);
        before = lobe;
    }
}

}  // namespace
}  // namespace lacquer
