// The models that `plain` stands beside, against their formulas and against what every model holds.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/error.h"
#include "integrate.h"
#include "reference/fresnel.h"
#include "reference/models.h"
#include "reference/openpbr_coat.h"
#include "reference/reflection.h"

namespace lacquer::reference {
namespace {

using std::numbers::pi;

constexpr Model kModels[] = {Model::clearcoat, Model::weidlich_wilkie, Model::openpbr_coat};

const LambertianBase kClay{{0.5, 0.3, 0.2}};
const LambertianBase kWhite{{1.0, 1.0, 1.0}};
const AbsorbingMedium kTinted{{0.9, 0.5, 0.1}};
const glm::dvec3 kNormal{0.0, 0.0, 1.0};

Microsurface facets(double alpha_x, double alpha_y) {
    return {Ndf::ggx, {alpha_x, alpha_y}};
}

Material coated(double ior, Microsurface microsurface, Base base, Medium medium = {}) {
    return {"test", 1.0, {{{ior, microsurface}, medium}}, std::move(base), {}};
}

Material bare(Base base) {
    return {"test", 1.0, {}, std::move(base), {}};
}

ConductorBase gold(Microsurface microsurface) {
    return {{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}, microsurface};
}

struct NamedMaterial {
    std::string name;
    Material material;
    double width;  // of its narrowest lobe
};

const std::vector<NamedMaterial>& materials() {
    static const std::vector<NamedMaterial> all{
        {"clay", bare(kClay), 1.0},
        {"gold", bare(gold(facets(0.2, 0.5))), 0.2},
        {"glass", coated(1.5, facets(0.3, 0.3), NoBase{}), 0.3},
        {"glaze", coated(1.5, facets(0.2, 0.2), kClay), 0.2},
        {"tinted glaze", coated(1.6, facets(0.3, 0.3), kClay, kTinted), 0.3},
        {"coated gold", coated(1.4, facets(0.2, 0.4), gold(facets(0.3, 0.3)), kTinted), 0.2},
    };
    return all;
}

class OneCoatModels : public ::testing::TestWithParam<Model> {};

TEST_P(OneCoatModels, AreTheBaseWithoutACoat) {
    for (const Material& material : {bare(kClay), bare(gold(facets(0.2, 0.5)))}) {
        const auto model = prepare(material, GetParam());
        const auto plain = prepare(material, Model::plain);
        const glm::dvec3 wi = test::direction(0.4, 0.3);
        const glm::dvec3 wo = test::direction(0.7, 2.8);
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(model->eval(wi, wo)[c], plain->eval(wi, wo)[c], 1e-15);
        EXPECT_EQ(model->pdf(wi, wo), plain->pdf(wi, wo));
        EXPECT_EQ(model->albedo(wo).base, plain->albedo(wo).base);
        EXPECT_EQ(model->albedo(wo).direct, glm::dvec3{0.0});
    }
}

TEST_P(OneCoatModels, ReflectOnlyAboveTheSurface) {
    const auto model = prepare(materials()[4].material, GetParam());
    const glm::dvec3 above = test::direction(0.5, 0.0);
    for (const glm::dvec3 below : {glm::dvec3{0.6, 0.0, -0.8}, glm::dvec3{1.0, 0.0, 0.0}}) {
        EXPECT_EQ(model->eval(above, below), glm::dvec3{0.0});
        EXPECT_EQ(model->eval(below, above), glm::dvec3{0.0});
        EXPECT_EQ(model->pdf(above, below), 0.0);
        EXPECT_EQ(model->pdf(below, above), 0.0);
        EXPECT_EQ(model->sample(below, {0.5, 0.5, 0.5}).pdf, 0.0);
        EXPECT_EQ(model->albedo(below).direct + model->albedo(below).base, glm::dvec3{0.0});
    }
}

// The definition: the integral of f cos_theta_i over the hemisphere.
TEST_P(OneCoatModels, AlbedoIsTheIntegralOfEval) {
    constexpr double kPanels = 2e-5;  // what the test's product of panels integrates these lobes to
    for (const NamedMaterial& entry : materials())
        for (const double cosine : {0.8, 0.15}) {
            const auto model = prepare(entry.material, GetParam());
            const glm::dvec3 wo = test::direction(cosine, 0.5);
            const Albedo fractions = model->albedo(wo);
            for (int c = 0; c < 3; c += 2) {
                const double integral = test::integrate_hemisphere(
                    [&](const glm::dvec3& wi) { return model->eval(wi, wo)[c] * wi.z; },
                    {-wo.x, -wo.y, wo.z}, entry.width);
                EXPECT_NEAR(fractions.direct[c] + fractions.base[c], integral, kPanels)
                    << entry.name << " at " << cosine << ", channel " << c;
            }
        }
}

// Sampled directions have the density that pdf tells, or their weights would average to something
// else. Narrow lobes and coats under which light is totally reflected included.
TEST_P(OneCoatModels, WeightsAverageToTheAlbedo) {
    constexpr int kSamples = 20'000;
    std::vector<NamedMaterial> all = materials();
    all.push_back({"varnish", coated(1.5, facets(0.0, 0.0), kClay, kTinted), 0});
    all.push_back({"air gap", coated(0.7, facets(0.2, 0.2), kClay, kTinted), 0});
    std::mt19937_64 generator(17);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const NamedMaterial& entry : all)
        for (const double cosine : {1.0, 0.3, 0.01}) {
            const auto model = prepare(entry.material, GetParam());
            const glm::dvec3 wo = test::direction(cosine, 0.5);
            double sum = 0.0;
            double squares = 0.0;
            for (int i = 0; i < kSamples; ++i) {
                const glm::dvec3 u{uniform(generator), uniform(generator), uniform(generator)};
                const Sample chosen = model->sample(wo, u);
                ASSERT_EQ(chosen.pdf, model->pdf(chosen.wi, wo));
                sum += chosen.weight.y;
                squares += chosen.weight.y * chosen.weight.y;
            }
            const double mean = sum / kSamples;
            const double deviation = std::sqrt(std::max(squares / kSamples - mean * mean, 0.0));
            const Albedo fractions = model->albedo(wo);
            constexpr double kQuadrature = 1e-6;
            EXPECT_NEAR(mean, fractions.direct.y + fractions.base.y,
                        4 * deviation / std::sqrt(kSamples) + kQuadrature)
                << entry.name << " at " << cosine;
        }
}

std::string error_of(const Material& material, Model model) {
    try {
        prepare(material, model);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST_P(OneCoatModels, NameThePointerOfWhatTheyCannotShade) {
    const std::string model{model_name(GetParam())};
    Material two = materials()[3].material;
    two.layers.push_back(two.layers[0]);
    EXPECT_EQ(error_of(two, GetParam()),
              "material 'test': /layers/1: the model '" + model + "' shades at most one layer");
    ScatteringMedium medium{{0.1, 0.1, 0.1}, {0.0, 0.0, 0.0}, 0.0, 2.0};
    EXPECT_EQ(error_of(coated(1.5, {}, kClay, medium), GetParam()), "");
    medium.sigma_s[2] = 0.1;
    EXPECT_EQ(error_of(coated(1.5, {}, kClay, medium), GetParam()),
              "material 'test': /layers/0/medium/sigma_s: the model '" + model +
                  "' cannot shade a medium that scatters");
    const Blend blend{Blend::Operator::symmetric, {Stratum{}, Stratum{}}};
    EXPECT_THAT(error_of(bare(ConductorBase{{}, {}, blend}), GetParam()),
                testing::HasSubstr("/base/conductor/blend: the model '" + model + "' cannot"));
}

// What only absorbs is the same in either notation: tau = exp(-sigma_a thickness).
TEST_P(OneCoatModels, TakeEitherNotationOfAnAbsorbingMedium) {
    const ScatteringMedium medium{{0.1, 0.2, 0.3}, {0.0, 0.0, 0.0}, 0.0, 2.0};
    const AbsorbingMedium same{{std::exp(-0.2), std::exp(-0.4), std::exp(-0.6)}};
    const glm::dvec3 wi = test::direction(0.4, 0.3);
    const glm::dvec3 f =
        prepare(coated(1.5, facets(0.2, 0.2), kClay, medium), GetParam())->eval(wi, kNormal);
    const glm::dvec3 expected =
        prepare(coated(1.5, facets(0.2, 0.2), kClay, same), GetParam())->eval(wi, kNormal);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[c], expected[c], 1e-15);
}

INSTANTIATE_TEST_SUITE_P(, OneCoatModels, ::testing::ValuesIn(kModels),
                         [](const auto& tested) { return std::string{model_level(tested.param)}; });

// Schlick's approximation for an index of 1.5 and glTF's mix of base and coat.
TEST(Clearcoat, IsTheFormulaOfGltf) {
    const Microsurface rough = facets(0.3, 0.3);
    const auto model = prepare(coated(1.5, rough, kClay, kTinted), Model::clearcoat);
    const glm::dvec3 wi = test::direction(0.9, 2.0);
    const glm::dvec3 wo = test::direction(0.5, 0.0);
    const double share = 0.04 + 0.96 / 32;
    const double lobe = reflection_lobe({Ndf::ggx, 0.3, 0.3}, wi, wo);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(model->eval(wi, wo)[c],
                    (1 - share) * kClay.albedo[static_cast<std::size_t>(c)] / pi + share * lobe,
                    1e-15);
}

// The coat's lobe loses what its facets hide, never more than its share comes back.
TEST(Clearcoat, ReflectsAtMostAllLight) {
    for (const double alpha : {0.0, 0.3, 1.0})
        for (const double cosine : {1.0, 0.5, 0.1, 0.01}) {
            const auto model = prepare(coated(1.5, facets(alpha, alpha), kWhite), Model::clearcoat);
            const Albedo fractions = model->albedo(test::direction(cosine, 0.0));
            EXPECT_LE(fractions.direct.x + fractions.base.x, 1.0 + 1e-7);
            EXPECT_GT(fractions.base.x, 0.0);
        }
}

TEST(WeidlichWilkie, IsReciprocal) {
    for (const NamedMaterial& entry : materials()) {
        const auto model = prepare(entry.material, Model::weidlich_wilkie);
        for (const double i : {1.0, 0.7, 0.2, 1e-3})
            for (const double o : {0.9, 0.3, 1e-4}) {
                const glm::dvec3 wi = test::direction(i, 0.4);
                const glm::dvec3 wo = test::direction(o, 3.0);
                const glm::dvec3 f = model->eval(wi, wo);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(f[c], model->eval(wo, wi)[c], 1e-12 * f[c]) << entry.name;
            }
    }
}

// Straight down nothing is refracted and little is hidden: T12 = T21 = 0.96, G = 1, and the medium
// is crossed twice.
TEST(WeidlichWilkie, IsItsFormulaAlongTheNormal) {
    const auto model =
        prepare(coated(1.5, facets(0.3, 0.3), kClay, kTinted), Model::weidlich_wilkie);
    const double coat = 0.04 / (pi * 0.09) / 4;  // F D / 4
    for (std::size_t c = 0; c < 3; ++c) {
        const double base = 0.96 * 0.96 * std::pow(kTinted.tau[c], 2) * kClay.albedo[c] / pi;
        EXPECT_NEAR(model->eval(kNormal, kNormal)[static_cast<int>(c)], coat + base, 1e-14);
    }
}

// In the mirror direction at 60 degrees Snell's law gives cos_theta_t = sqrt(1 - 0.75 / 2.25).
TEST(WeidlichWilkie, MeetsTheBaseInTheRefractedDirections) {
    const Microsurface rough = facets(0.4, 0.4);
    const glm::dvec3 wo = test::direction(0.5, 0.0);
    const glm::dvec3 wi{-wo.x, 0.0, wo.z};
    const double cos_theta_t = std::sqrt(2.0 / 3.0);
    const glm::dvec3 below = test::direction(cos_theta_t, 0.0);
    const Facets shape{Ndf::ggx, 0.4, 0.4};
    const double transmittance = 1 - fresnel(0.5, 1.5);
    const double g = masking_shadowing(shape, wi, wo);
    const double coat = fresnel(0.5, 1.5) * reflection_lobe(shape, wi, wo);
    const double conductor = fresnel(cos_theta_t, std::complex{0.143, 3.983} / 1.5) *
                             reflection_lobe(shape, {-below.x, 0.0, below.z}, below);
    const double medium = std::pow(0.9, 2 / cos_theta_t);
    const auto model = prepare(coated(1.5, rough, gold(rough), kTinted), Model::weidlich_wilkie);
    EXPECT_NEAR(model->eval(wi, wo).x,
                coat + transmittance * medium * (1 - g + transmittance * g) * conductor, 1e-13);
}

// Delta = (1 - K) / (1 - E_b K), with K_r from the average Fresnel reflectance of 1.5, which is
// 0.0918 (Duntley 1942), to the 0.2 % of the specification's fit.
TEST(OpenpbrCoat, DarkensALambertianBaseByItsFormula) {
    const auto model = prepare(coated(1.5, facets(0.3, 0.3), kClay, kTinted), Model::openpbr_coat);
    const double coat = 0.04 / (pi * 0.09) / 4;
    const double k = 1 - (1 - 0.0918) / 2.25;
    for (std::size_t c = 0; c < 3; ++c) {
        const double albedo = kClay.albedo[c];
        const double base =
            0.96 * std::pow(kTinted.tau[c], 2) * albedo / pi * (1 - k) / (1 - albedo * k);
        EXPECT_NEAR(model->eval(kNormal, kNormal)[static_cast<int>(c)], coat + base, 2e-3 * base);
    }
}

// At 60 degrees both paths through 1.5 are 1 / sqrt(1 - 0.75 / 2.25) long.
TEST(OpenpbrCoat, AbsorbsAlongRefractedPaths) {
    const glm::dvec3 wi = test::direction(0.5, 0.3);
    const glm::dvec3 wo = test::direction(0.5, 1.0);
    const Microsurface rough = facets(0.05, 0.05);
    const auto clear = prepare(coated(1.5, rough, kClay), Model::openpbr_coat);
    const auto tinted = prepare(coated(1.5, rough, kClay, kTinted), Model::openpbr_coat);
    const auto black = prepare(coated(1.5, rough, LambertianBase{}), Model::openpbr_coat);
    for (int c = 0; c < 3; ++c) {
        const double coat = black->eval(wi, wo)[c];
        EXPECT_NEAR((tinted->eval(wi, wo)[c] - coat) / (clear->eval(wi, wo)[c] - coat),
                    std::pow(kTinted.tau[static_cast<std::size_t>(c)], 2 / std::sqrt(2.0 / 3.0)),
                    1e-12);
    }
}

// A white base under a smooth clear coat returns all light: Delta is 1, and what the coat does not
// reflect passes.
TEST(OpenpbrCoat, ReturnsAllLightOfAWhiteBaseUnderASmoothCoat) {
    for (const double ior : {0.7, 1.2, 1.5, 2.5})
        for (const double cosine : {1.0, 0.8, 0.5}) {
            const Albedo fractions =
                prepare(coated(ior, facets(0.0, 0.0), kWhite), Model::openpbr_coat)
                    ->albedo(test::direction(cosine, 0.0));
            constexpr double kLeastAlpha = 1e-4;  // of a coat shaded at alpha 1e-3
            EXPECT_NEAR(fractions.direct.x + fractions.base.x, 1.0, kLeastAlpha)
                << ior << " at " << cosine;
        }
}

// r'^4 = r^4 + 2 r_coat^4 with alpha = r^2, kept below 1; an anisotropic base keeps its ratio.
TEST(OpenpbrCoat, RoughensAConductorBelowIt) {
    const auto below = [](Microsurface coat, Microsurface base) {
        return prepare_openpbr_coat(coated(1.5, coat, gold(base))).conductor->facets;
    };
    EXPECT_NEAR(below(facets(0.3, 0.3), facets(0.2, 0.2)).alpha_x, std::sqrt(0.04 + 0.18), 1e-15);
    EXPECT_EQ(below(facets(0.9, 0.9), facets(0.2, 0.2)).alpha_x, 1.0);
    const Facets brushed = below(facets(0.3, 0.3), facets(0.1, 0.4));
    EXPECT_NEAR(brushed.alpha_y / brushed.alpha_x, 4.0, 1e-13);
    EXPECT_NEAR(brushed.alpha_x * brushed.alpha_x + brushed.alpha_y * brushed.alpha_y,
                0.17 + 4 * 0.09, 1e-13);
    EXPECT_NEAR(
        prepare_openpbr_coat(coated(1.5, facets(0.3, 0.3), gold(facets(0.2, 0.2)))).base_roughness,
        std::sqrt(0.2), 1e-15);
}

}  // namespace
}  // namespace lacquer::reference
