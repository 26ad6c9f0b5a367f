// The energies of `coated` against closed forms, and what it takes from a material.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "coated_surface.h"
#include "core/error.h"
#include "integrate.h"
#include "reference/equivalent_alpha.h"
#include "support/smooth_dielectric.h"

namespace lacquer::reference {
namespace {

using std::numbers::pi;
using namespace surfaces;

TEST(Coated, WhiteFurnaceReturnsEverything) {
    constexpr double kRounding = 1e-12;
    for (const double eta : {1.0 / 3.0, 0.5, 0.8, 0.99, 1.0, 1.01, 1.3, 1.5, 2.0, 3.0})
        for (const double alpha : {0.0, 0.001, 0.03, 0.1, 0.3, 0.6, 1.0})
            for (const double cosine : {1.0, 0.9, 0.7, 0.5, 0.3, 0.1, 0.01, 1e-4}) {
                const Albedo fractions = albedo(prepare(coated(eta, ggx(alpha), kWhite, kWhite)),
                                                test::direction(cosine, 0.2));
                EXPECT_NEAR(fractions.direct.x + fractions.base.x, 1.0, kRounding)
                    << eta << " " << alpha << " at " << cosine;
            }
}

// Adding at a smooth interface: what enters is 1 - F, crosses with tau^(1 / cos_theta_t); inside,
// diffuse light crosses up, is reflected or leaves, and crosses down.
struct SmoothCoat {
    double entering, leaving, returning;
};

SmoothCoat smooth_coat(double eta, double tau, double cosine) {
    const auto crossing = [tau](double cos_inside) { return std::pow(tau, 1.0 / cos_inside); };
    const double cos_inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (eta * eta));
    SmoothCoat coat{(1.0 - test::smooth_reflectance(cosine, eta)) * crossing(cos_inside), 0.0, 0.0};
    constexpr int kSteps = 100'000;
    for (int step = 0; step < kSteps; ++step) {
        const double c = (step + 0.5) / kSteps;
        const double up = 2.0 * c * crossing(c) / kSteps;
        const double reflected = test::smooth_reflectance(c, 1.0 / eta);
        coat.leaving += up * (1.0 - reflected);
        coat.returning += up * reflected * crossing(c);
    }
    return coat;
}

TEST(Coated, SmoothCoatsAreTheClosedForm) {
    for (const double eta : {0.6, 0.9, 1.2, 1.5, 2.5})
        for (const double tau : {1.0, 0.5, 0.1})
            for (const double cosine : {1.0, 0.85, 0.5}) {
                if (cosine * cosine < 1.0 - eta * eta) continue;  // nothing enters
                const SmoothCoat coat = smooth_coat(eta, tau, cosine);
                const double rho = 0.5;
                const double expected =
                    coat.entering * rho * coat.leaving / (1.0 - rho * coat.returning);
                const Albedo fractions =
                    albedo(prepare(coated(eta, ggx(0.0), {tau, tau, tau}, {rho, rho, rho})),
                           test::direction(cosine, 0.0));
                EXPECT_NEAR(fractions.base.x, expected, kTableError * rho)
                    << eta << " " << tau << " at " << cosine;
                EXPECT_NEAR(fractions.direct.x, test::smooth_reflectance(cosine, eta), kTableError)
                    << eta << " at " << cosine;
            }
}

// The same by another method: the sum over reflections inside, eta 1.5, rho 0.5, cos_theta_o 0.5.
TEST(Coated, SmoothGlazeOverGreyIsTheKnownValue) {
    const double inside = 1.0 - (1.0 - test::smooth_diffuse_reflectance(1.5)) / (1.5 * 1.5);
    double sum = 0.0;
    double light = 1.0 - test::smooth_reflectance(0.5, 1.5);
    for (int bounce = 0; bounce < 100; ++bounce) {
        light *= 0.5;
        sum += light * (1.0 - inside);
        light *= inside;
    }
    EXPECT_NEAR(sum, 0.2619, 5e-5);
    const Albedo fractions =
        albedo(prepare(coated(1.5, ggx(0.0), kWhite, {0.5, 0.5, 0.5})), test::direction(0.5, 0.0));
    EXPECT_NEAR(fractions.base.x, sum, kUsualTableError);
}

TEST(Coated, NothingReturnsThroughAnOpaqueMedium) {
    const CoatedSurface surface = prepare(coated(1.5, ggx(0.2), {0.0, 0.5, 1.0}, kWhite));
    const glm::dvec3 wo = test::direction(0.6, 0.0);
    EXPECT_EQ(albedo(surface, wo).base.x, 0.0);
    EXPECT_GT(albedo(surface, wo).base.y, 0.0);
    EXPECT_EQ(base_lobe(surface.base, test::direction(0.9, 0.0), wo).x, 0.0);
    // All channels opaque: the ggx lobe has no light to take its variance from.
    const CoatedSurface black = prepare(coated(1.5, ggx(0.2), {0, 0, 0}, kWhite), BaseLobe::ggx);
    EXPECT_EQ(albedo(black, wo).base, glm::dvec3{0.0});
    EXPECT_GT(eval(black, wo, wo).x, 0.0);
}

// Without contrast light goes straight through: f = rho / pi tau^(1 / cos_i + 1 / cos_o).
TEST(Coated, CoatWithoutContrastOnlyAbsorbs) {
    const double tau = 0.6;
    const CoatedSurface surface = prepare(coated(1.0, ggx(0.4), {tau, tau, tau}, {0.8, 0.8, 0.8}));
    for (const double i : {1.0, 0.6, 0.3})
        for (const double o : {1.0, 0.5, 0.2}) {
            const double f = eval(surface, test::direction(i, 0.1), test::direction(o, 2.0)).x;
            EXPECT_NEAR(f, 0.8 / pi * std::pow(tau, 1.0 / i + 1.0 / o),
                        2.0 * kTableError * 0.8 / pi)
                << i << " " << o;
        }
}

TEST(Coated, TheIndexIsRelativeToTheExterior) {
    Material material = coated(1.5, ggx(0.2), kGlazeTau, kClay);
    material.exterior_ior = 1.2;
    EXPECT_NEAR(prepare(material).coat.eta, 1.25, 1e-15);
    // Numbers rounded to float may leave the tables' range by as much.
    material = coated(static_cast<double>(3.9f), ggx(0.2), kGlazeTau, kClay);
    material.exterior_ior = static_cast<double>(1.3f);
    EXPECT_NO_THROW(prepare(material));
    material.exterior_ior = 1.0;
    EXPECT_THROW(prepare(material), Error);
}

TEST(Coated, AbsorptionMayBeGivenByItsCoefficient) {
    Material material = coated(1.5, ggx(0.2), {0.5, 0.25, 1.0}, kWhite);
    const glm::dvec3 wi = test::direction(0.6, 1.0);
    const glm::dvec3 wo = test::direction(0.7, 3.0);
    const glm::dvec3 by_tau = eval(prepare(material), wi, wo);
    material.layers[0].medium =
        ScatteringMedium{{0.5 * std::log(2.0), std::log(2.0), 0.0}, {}, 0.0, 2.0};
    const glm::dvec3 by_sigma = eval(prepare(material), wi, wo);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(by_sigma[c], by_tau[c], 1e-12);
}

TEST(Coated, NarrowLobesAreShadedAtTheirLeastWidthAndTrueEnergy) {
    const CoatedSurface surface = prepare(coated(1.5, ggx(0.0), kWhite, kClay));
    EXPECT_EQ(surface.coat.side.facets.strata.front().facets.alpha_x, 1e-3);
    EXPECT_EQ(equivalent_ggx_alpha(ggx(0.0), 1.5), 0.0);
}

TEST(EquivalentAlpha, IsTheRoughnessItselfOfIsotropicGgx) {
    for (const double alpha : {0.0, 0.3, 1.0})
        for (const double eta : {0.5, 1.5}) EXPECT_EQ(equivalent_ggx_alpha(ggx(alpha), eta), alpha);
    EXPECT_NEAR(equivalent_ggx_alpha({Ndf::ggx, {0.1, 0.5}}, 1.5), 0.3, 1e-15);
}

TEST(EquivalentAlpha, IsLessForBeckmannAndGrowsWithRoughness) {
    for (const double eta : {0.5, 1.5}) {
        double last = 0.0;
        for (const double alpha : {0.05, 0.2, 0.5, 1.0}) {
            const double equivalent = equivalent_ggx_alpha({Ndf::beckmann, {alpha, alpha}}, eta);
            EXPECT_LT(equivalent, alpha);
            EXPECT_GT(equivalent, last);
            last = equivalent;
        }
    }
}

std::string error_of(const Material& material) {
    try {
        prepare(material);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(Coated, RefusesWhatItCannotShadeByItsPointer) {
    const Material glaze = coated(1.5, ggx(0.2), kGlazeTau, kClay);
    Material material = glaze;
    material.layers.clear();
    EXPECT_EQ(error_of(material),
              "material 'test': /layers: 0 layers; the coated models shade one layer over a "
              "Lambertian base");
    material.layers = {glaze.layers[0], glaze.layers[0]};
    EXPECT_THAT(error_of(material), testing::HasSubstr("/layers: 2 layers"));
    for (const Base& base : {Base{ConductorBase{}}, Base{DiffuseFacetsBase{}}, Base{NoBase{}}}) {
        material = glaze;
        material.base = base;
        EXPECT_THAT(error_of(material), testing::HasSubstr("/base: not Lambertian"));
    }
    material = glaze;
    material.layers[0].medium = ScatteringMedium{{}, {0.0, 0.1, 0.0}, 0.0, 1.0};
    EXPECT_THAT(error_of(material), testing::HasSubstr("/layers/0/medium/sigma_s"));
}

}  // namespace
}  // namespace lacquer::reference
