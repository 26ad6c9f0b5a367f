// The model `coated` against its definition and closed forms.
#include "reference/coated.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "coated_surface.h"
#include "integrate.h"
#include "reference/reflection.h"

namespace lacquer::reference {
namespace {

using std::numbers::pi;
using namespace surfaces;

struct NamedMaterial {
    std::string name;
    Material material;
    double width;  // of the coat's lobe
};

const std::vector<NamedMaterial>& materials() {
    static const std::vector<NamedMaterial> all{
        {"glaze", coated(1.5, ggx(0.2), kGlazeTau, kClay), 0.2},
        {"matt lacquer", coated(1.6, {Ndf::beckmann, {0.5, 0.5}}, {0.9, 0.1, 0.0}, kWhite), 0.5},
        {"brushed varnish", coated(1.4, {Ndf::ggx, {0.15, 0.6}}, kGlazeTau, kClay), 0.15},
        {"film of air", coated(0.7, ggx(0.3), kGlazeTau, kWhite), 0.3},
        {"rough film of air", coated(0.5, ggx(1.0), kWhite, kWhite), 0.5},
        {"black base", coated(2.0, ggx(0.4), kWhite, {0, 0, 0}), 0.4},
        {"no contrast", coated(1.0, ggx(0.3), kGlazeTau, kClay), 0.3},
    };
    return all;
}

const std::vector<double> kCosines{1.0, 0.8, 0.4, 0.1};

// 2 pi times the integral over cos_theta_i of what does not depend on the azimuth, with its kink at
// the critical angle.
template <typename Function>
double integrate_cosine(const Function& f, double eta) {
    const auto at = [&](double z) { return f(test::direction(z, 0.3)) * z; };
    return 2.0 * pi * test::integrate_between(at, {0.0, critical_cosine(eta), 1.0}, 1e-9);
}

TEST(Coated, ExactIsReciprocal) {
    for (const NamedMaterial& entry : materials()) {
        const CoatedSurface surface = prepare(entry.material);
        for (const double i : {1.0, 0.7, 0.2, 1e-3})
            for (const double o : {0.9, 0.3, 1e-4}) {
                const glm::dvec3 wi = test::direction(i, 0.4);
                const glm::dvec3 wo = test::direction(o, 3.0);
                const glm::dvec3 f = eval(surface, wi, wo);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(f[c], eval(surface, wo, wi)[c], 1e-12 * f[c]) << entry.name;
            }
    }
}

TEST(Coated, ReflectsOnlyAboveTheSurface) {
    const glm::dvec3 above = test::direction(0.5, 0.0);
    for (const BaseLobe shape : {BaseLobe::exact, BaseLobe::ggx}) {
        const CoatedSurface surface = prepare(materials()[0].material, shape);
        for (const glm::dvec3 below : {glm::dvec3{0.6, 0.0, -0.8}, glm::dvec3{1.0, 0.0, 0.0}}) {
            EXPECT_EQ(eval(surface, above, below), glm::dvec3{0.0});
            EXPECT_EQ(eval(surface, below, above), glm::dvec3{0.0});
            EXPECT_EQ(pdf(surface, above, below), 0.0);
            EXPECT_EQ(pdf(surface, below, above), 0.0);
            EXPECT_EQ(sample(surface, below, {0.5, 0.5, 0.5}).pdf, 0.0);
            EXPECT_EQ(sample(surface, below, {0.5, 0.5, 0.5}).weight, glm::dvec3{0.0});
            EXPECT_EQ(albedo(surface, below).direct + albedo(surface, below).base, glm::dvec3{0.0});
        }
    }
}

// The tables clamp T01 to [0, 1] in a direction, which its average does not know.
TEST(Coated, BaseAlbedoIsTheIntegralOfTheExactLobe) {
    constexpr double kClamping = 1e-3;
    for (const NamedMaterial& entry : materials()) {
        const CoatedSurface surface = prepare(entry.material);
        for (const double cosine : kCosines) {
            const glm::dvec3 wo = test::direction(cosine, 0.5);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(
                    integrate_cosine(
                        [&](const glm::dvec3& wi) { return base_lobe(surface.base, wi, wo)[c]; },
                        surface.coat.eta),
                    base_albedo(surface.base, wo)[c], kClamping)
                    << entry.name << " at " << cosine;
        }
    }
}

// De Dinechin and Belcour 2022, eq. 5: normalised to rho_2+.
TEST(Coated, BaseAlbedoIsTheIntegralOfTheGgxLobe) {
    constexpr double kNormTableError = 2e-3;  // relative, of mirror_single
    for (const NamedMaterial& entry : materials()) {
        const CoatedSurface surface = prepare(entry.material, BaseLobe::ggx);
        const glm::dvec3 wo = test::direction(0.7, 0.5);
        const glm::dvec3 energy = base_albedo(surface.base, wo);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(
                integrate_cosine(
                    [&](const glm::dvec3& wi) { return base_lobe(surface.base, wi, wo)[c]; }, 1.0),
                energy[c], kNormTableError * energy[c])
                << entry.name;
    }
}

// sigma_2+ of the paper, as the variance per axis of the lobe that stands for it.
TEST(Coated, GgxLobeHasTheVarianceOfTheLight) {
    constexpr double kVarianceTableError = 1e-3;
    for (const double variance : {0.02, 0.1, 0.2}) {
        const NormalLobe lobe = prepare_normal_lobe(variance, tables());
        const auto moment = [&](int power) {
            return integrate_cosine(
                [&](const glm::dvec3& wi) {
                    return normal_lobe(lobe, wi) * std::pow(1.0 - wi.z * wi.z, power);
                },
                1.0);
        };
        EXPECT_NEAR(0.5 * moment(1) / moment(0), variance, kVarianceTableError);
    }
}

// The coat's albedo is from the table of T01; its diffuse part from one whose errors are largest at
// grazing angles of smooth facets (tables/README.md: on its grid, 0.003 in the mean).
TEST(Coated, CoatAlbedoIsTheIntegralOfItsLobe) {
    constexpr double kMultipleError = 0.035;
    constexpr double kMultipleMeanError = 0.003;
    double sum = 0.0;
    int count = 0;
    for (const double eta : {0.4, 0.8, 1.2, 1.5, 2.7})
        for (const double alpha : {0.1, 0.4, 1.0})
            for (const double cosine : kCosines) {
                const CoatedSurface surface = prepare(coated(eta, ggx(alpha), kWhite, {0, 0, 0}));
                const glm::dvec3 wo = test::direction(cosine, 0.5);
                const double integral = test::integrate_hemisphere(
                    [&](const glm::dvec3& wi) { return eval(surface, wi, wo).x * wi.z; },
                    {-wo.x, -wo.y, wo.z}, alpha);
                const double error = std::abs(albedo(surface, wo).direct.x - integral);
                EXPECT_LE(error, kMultipleError + kTableError)
                    << eta << " " << alpha << " at " << cosine;
                sum += error;
                ++count;
            }
    EXPECT_LE(sum / count, kMultipleMeanError + kUsualTableError);
}

TEST(Coated, StaysFiniteAtTheEnds) {
    for (const double eta : {1.0 / 3.0, 0.999999, 1.0, 3.0})
        for (const double alpha : {0.0, 1e-3, 1.0})
            for (const BaseLobe shape : {BaseLobe::exact, BaseLobe::ggx}) {
                const CoatedSurface surface =
                    prepare(coated(eta, ggx(alpha), {0.0, 1e-6, 1.0}, kWhite), shape);
                for (const double i : {1.0, 1.0 + 6e-8, 1e-7, 1e-30})
                    for (const double o : {1.0, 0.3, 1e-7, 1e-30}) {
                        glm::dvec3 wi = test::direction(std::min(i, 1.0), 1.0);
                        wi.z = i;
                        const glm::dvec3 wo = test::direction(o, 4.0);
                        const glm::dvec3 f = eval(surface, wi, wo) * wi.z;
                        const double density = pdf(surface, wi, wo);
                        for (const double value : {f.x, f.y, f.z, density}) {
                            EXPECT_TRUE(std::isfinite(value)) << eta << " " << alpha;
                            EXPECT_GE(value, 0.0) << eta << " " << alpha;
                        }
                    }
            }
}

// The part of the coat's samples that end below the horizon: their density goes on there.
double share_below(const CoatedSurface& surface, const glm::dvec3& wo, double width) {
    const auto lobe = [&](const glm::dvec3& wi) { return coat_pdf(surface.coat, wi, wo); };
    // A mirror direction lies above -wo.
    return test::integrate_zone(lobe, pi / 2, pi - std::acos(wo.z), -wo, width);
}

// How often the coat is chosen for wo, by the words of coated.h.
double documented_choice(const CoatedSurface& surface, const glm::dvec3& wo) {
    const Albedo fractions = albedo(surface, wo);
    const double base = (fractions.base.x + fractions.base.y + fractions.base.z) / 3;
    const double coat = fractions.direct.x;
    if (coat == 0.0) return 0.0;
    if (base == 0.0) return 1.0;
    return std::min(std::max(coat / (coat + base), 0.1), 0.9);
}

TEST(Coated, PdfIntegratesToOneLessWhatEndsBelow) {
    constexpr double kTolerance = 1e-3;
    for (const NamedMaterial& entry : materials())
        for (const BaseLobe shape : {BaseLobe::exact, BaseLobe::ggx})
            for (const double cosine : kCosines) {
                const CoatedSurface surface = prepare(entry.material, shape);
                const glm::dvec3 wo = test::direction(cosine, 0.5);
                const double above = test::integrate_hemisphere(
                    [&](const glm::dvec3& wi) { return pdf(surface, wi, wo); },
                    {-wo.x, -wo.y, wo.z}, entry.width);
                const double below =
                    documented_choice(surface, wo) * share_below(surface, wo, entry.width);
                EXPECT_NEAR(above + below, 1.0, kTolerance) << entry.name << " at " << cosine;
            }
}

struct MeanWeight {
    double mean, standard_error;
};

MeanWeight mean_weight(const CoatedSurface& surface, const glm::dvec3& wo) {
    constexpr int kSamples = 40'000;
    std::mt19937_64 generator(17);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    double sum = 0.0;
    double squares = 0.0;
    for (int n = 0; n < kSamples; ++n) {
        const glm::dvec3 u{uniform(generator), uniform(generator), uniform(generator)};
        const double weight = sample(surface, wo, u).weight.y;
        sum += weight;
        squares += weight * weight;
    }
    const double mean = sum / kSamples;
    return {mean, std::sqrt(std::max(squares / kSamples - mean * mean, 0.0) / kSamples)};
}

TEST(Coated, WeightsAverageToTheIntegralOfEval) {
    constexpr double kQuadrature = 1e-3;  // as the pdf's above
    for (const NamedMaterial& entry : materials())
        for (const BaseLobe shape : {BaseLobe::exact, BaseLobe::ggx})
            for (const double cosine : kCosines) {
                const CoatedSurface surface = prepare(entry.material, shape);
                const glm::dvec3 wo = test::direction(cosine, 0.5);
                const double integral = test::integrate_hemisphere(
                    [&](const glm::dvec3& wi) { return eval(surface, wi, wo).y * wi.z; },
                    {-wo.x, -wo.y, wo.z}, entry.width);
                const MeanWeight weights = mean_weight(surface, wo);
                EXPECT_NEAR(weights.mean, integral, 4 * weights.standard_error + kQuadrature)
                    << entry.name << " at " << cosine;
            }
}

// Narrow lobes as well, which quadrature over the hemisphere cannot resolve. Not at grazing angles,
// where the table of the coat's diffuse part is off by more.
TEST(Coated, WeightsAverageToTheAlbedo) {
    for (const double alpha : {0.0, 0.01, 0.1, 0.5})
        for (const double eta : {0.6, 1.5})
            for (const double cosine : {1.0, 0.6, 0.2}) {
                const CoatedSurface surface = prepare(coated(eta, ggx(alpha), kGlazeTau, kClay));
                const glm::dvec3 wo = test::direction(cosine, 0.5);
                const Albedo fractions = albedo(surface, wo);
                const MeanWeight weights = mean_weight(surface, wo);
                EXPECT_NEAR(weights.mean, fractions.direct.y + fractions.base.y,
                            4 * weights.standard_error + 2.0 * kTableError)
                    << eta << " " << alpha << " at " << cosine;
            }
}

TEST(Coated, SamplesCarryTheirPdfAndWeight) {
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const NamedMaterial& entry : materials())
        for (const BaseLobe shape : {BaseLobe::exact, BaseLobe::ggx}) {
            const CoatedSurface surface = prepare(entry.material, shape);
            for (int n = 0; n < 1000; ++n) {
                const glm::dvec3 wo =
                    test::direction(uniform(generator) + 1e-6, 6 * uniform(generator));
                const Sample chosen = sample(
                    surface, wo, {uniform(generator), uniform(generator), uniform(generator)});
                EXPECT_NEAR(glm::length(chosen.wi), 1.0, 1e-12);
                EXPECT_EQ(chosen.pdf, pdf(surface, chosen.wi, wo));
                EXPECT_EQ(chosen.pdf > 0.0, chosen.wi.z > 0.0) << entry.name;
                const glm::dvec3 light = eval(surface, chosen.wi, wo) * std::max(chosen.wi.z, 0.0);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(chosen.weight[c] * chosen.pdf, light[c], 1e-12 * (1 + light[c]));
            }
        }
}

TEST(Coated, ChoosesTheCoatAsDocumented) {
    const CoatedSurface surface = prepare(materials()[0].material);
    const glm::dvec3 wo = test::direction(0.2, 0.0);
    const double coat = documented_choice(surface, wo);
    ASSERT_GT(coat, 0.1);
    ASSERT_LT(coat, 0.9);
    const double once = coat * single_share(surface.coat, wo);
    const glm::dvec2 point{0.25, 0.5};
    const auto chosen = [&](double u) { return sample(surface, wo, {u, point.x, point.y}).wi; };
    EXPECT_EQ(chosen(0.0),
              reflection_sample(surface.coat.side.facets.strata.front().facets, wo, point));
    EXPECT_EQ(chosen(once - 1e-9),
              reflection_sample(surface.coat.side.facets.strata.front().facets, wo, point));
    // Malley's method for what met more than one facet, and for the base.
    for (const double u : {once + 1e-9, coat - 1e-9, coat + 1e-9, 1.0 - 1e-9})
        EXPECT_NEAR(chosen(u).z, std::sqrt(1 - point.x), 1e-12) << u;
}

}  // namespace
}  // namespace lacquer::reference
