// The operator of a scattering slab: closed forms, conservation, limits and ranges.
#include "reference/stack/scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace lacquer {
namespace {

using reference::alpha_of_spread;
using reference::ScatteringSlab;
using reference::slab_light;
using reference::SlabLight;

// Of sums of a few terms of order 1; quotients near the resonance of beam and streams, of two
// numbers of order 1e-3, lose as many digits.
constexpr double kRounding = 1e-12;

const std::vector<double> kCosines{0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0};
const std::vector<double> kAnisotropies{-0.99, -0.9, -0.4, 0.0, 0.2, 0.5, 0.7, 0.85, 0.95, 0.99};
const std::vector<double> kDepths{0.0, 1e-9, 1e-6, 1e-3, 0.03,  0.1,
                                  0.3, 1.0,  3.0,  10.0, 100.0, 1e6};

template <typename Check>
void everywhere(const Check& check) {
    for (const double absorption : kDepths)
        for (const double scattering : kDepths)
            for (const double g : kAnisotropies)
                for (const double cosine : kCosines)
                    check(ScatteringSlab{absorption, scattering, g}, cosine);
}

double sum(const SlabLight& light) {
    return light.transmitted() + light.back;
}

TEST(Scattering, OfNothingIsBeersLaw) {
    for (const double absorption : kDepths)
        for (const double g : kAnisotropies)
            for (const double cosine : kCosines) {
                const ScatteringSlab slab{absorption, 0.0, g};
                const SlabLight light = slab_light(slab, cosine);
                EXPECT_NEAR(light.transmitted(), std::exp(-absorption / cosine), kRounding);
                EXPECT_EQ(light.back, 0.0);
                EXPECT_EQ(reference::transmitted_lobe(slab, cosine).spread, 0.0);
                EXPECT_EQ(reference::transmitted_lobe(slab, cosine).sine_ratio, 1.0);
            }
}

TEST(Scattering, LosesNothingWithoutAbsorption) {
    for (const double scattering : kDepths)
        for (const double g : kAnisotropies)
            for (const double cosine : kCosines)
                EXPECT_NEAR(sum(slab_light({0.0, scattering, g}, cosine)), 1.0, kRounding)
                    << scattering << ' ' << g << ' ' << cosine;
}

TEST(Scattering, SharesAreWithinTheLightThatCame) {
    everywhere([](const ScatteringSlab& slab, double cosine) {
        const SlabLight light = slab_light(slab, cosine);
        ASSERT_GE(light.unscattered, 0.0);
        ASSERT_GE(light.scattered, 0.0);
        ASSERT_GE(light.back, 0.0);
        ASSERT_LE(sum(light), 1.0 + kRounding)
            << slab.absorption << ' ' << slab.scattering << ' ' << slab.g << ' ' << cosine;
    });
}

TEST(Scattering, StraightForwardLeavesLightAlone) {
    // Light that scattering turns by 1 - g per depth: what goes back is of that order.
    constexpr double kAlmostStraight = 1e-9;
    for (const double cosine : kCosines) {
        const SlabLight light = slab_light({0.4, 3.0, 1.0 - kAlmostStraight}, cosine);
        EXPECT_NEAR(light.transmitted(), std::exp(-0.4 / cosine), 1e3 * kAlmostStraight);
        EXPECT_NEAR(light.back, 0.0, 1e3 * kAlmostStraight);
    }
}

TEST(Scattering, DeeperSlabsTransmitLessAndSendBackMore) {
    for (const double g : kAnisotropies)
        for (const double albedo : {0.3, 0.9, 1.0})
            for (const double cosine : kCosines) {
                SlabLight before{1.0, 0.0, 0.0};
                for (double depth = 0.05; depth < 20.0; depth *= 1.3) {
                    const SlabLight light =
                        slab_light({(1.0 - albedo) * depth, albedo * depth, g}, cosine);
                    ASSERT_LT(light.transmitted(), before.transmitted() + kRounding);
                    ASSERT_GT(light.back, before.back - kRounding)
                        << depth << ' ' << albedo << ' ' << g << ' ' << cosine;
                    before = light;
                }
            }
}

TEST(Scattering, AbsorptionTakesFromBothSides) {
    constexpr double kStep = 2e-3;  // at the resonance of beam and streams
    for (const double g : kAnisotropies)
        for (const double cosine : kCosines) {
            SlabLight before = slab_light({0.0, 1.5, g}, cosine);
            for (double absorption = 0.01; absorption < 5.0; absorption *= 1.3) {
                const SlabLight light = slab_light({absorption, 1.5, g}, cosine);
                ASSERT_LT(light.transmitted(), before.transmitted() + kStep);
                ASSERT_LT(light.back, before.back + kStep);
                before = light;
            }
        }
}

TEST(Scattering, IsContinuousAcrossTheResonanceOfBeamAndStreams) {
    constexpr double kStep = 2e-3;
    for (const double g : {-0.5, 0.0, 0.4, 0.8}) {
        SlabLight before = slab_light({1.0, 0.5, g}, 0.2);
        for (double cosine = 0.2; cosine <= 1.0; cosine += 1e-4) {
            const SlabLight light = slab_light({1.0, 0.5, g}, cosine);
            ASSERT_NEAR(light.scattered, before.scattered, kStep) << cosine;
            ASSERT_NEAR(light.back, before.back, kStep) << cosine;
            before = light;
        }
    }
}

TEST(Scattering, LobesAreFinite) {
    everywhere([](const ScatteringSlab& slab, double cosine) {
        const SlabLight light = slab_light(slab, cosine);
        for (const reference::SlabLobe& lobe :
             {reference::transmitted_lobe(slab, cosine),
              reference::scattered_lobe(slab, cosine, light), reference::back_lobe(slab, cosine)}) {
            ASSERT_GE(lobe.spread, 0.0);
            ASSERT_LE(lobe.spread, 1.0);  // of unit directions
            ASSERT_GE(lobe.sine_ratio, 0.0);
            ASSERT_LE(lobe.sine_ratio, 1.0 + kRounding);
        }
    });
}

TEST(Scattering, MoreOfItMakesWiderLobes) {
    for (const double g : kAnisotropies)
        for (const double cosine : kCosines) {
            double before = 0.0;
            for (double depth = 0.01; depth < 20.0; depth *= 1.3) {
                const double spread = reference::transmitted_lobe({0.1, depth, g}, cosine).spread;
                ASSERT_GE(spread, before);
                before = spread;
            }
        }
}

TEST(Scattering, WiderLobesAreRougher) {
    for (const double cosine : kCosines) {
        double before = 0.0;
        for (double spread = 0.0; spread <= 0.6; spread += 0.01) {
            const double alpha = alpha_of_spread(spread, cosine);
            ASSERT_GE(alpha, before) << spread << ' ' << cosine;
            ASSERT_LE(alpha, 1.0);
            before = alpha;
        }
    }
}

TEST(Scattering, PapersFitHasItsValues) {
    // Belcour 2018, Eqs. 15, 21 and 22 by hand.
    EXPECT_NEAR(reference::scattering_variance_2018(0.5), 2.0 / 3.0, kRounding);
    EXPECT_NEAR(reference::scattering_variance_2018(1.0), 0.0, kRounding);
    const SlabLight light = reference::slab_light_2018({0.2, 0.3, 0.7}, 0.5);
    EXPECT_NEAR(light.unscattered, std::exp(-1.0), kRounding);
    EXPECT_NEAR(light.scattered, 0.6 * std::exp(-1.0), kRounding);
    EXPECT_EQ(light.back, 0.0);
}

}  // namespace
}  // namespace lacquer
