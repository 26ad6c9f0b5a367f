// The model `plain` against its definition.
#include "reference/plain.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "core/error.h"
#include "integrate.h"
#include "reference/fresnel.h"
#include "reference/reflection.h"

namespace lacquer::reference {
namespace {

using std::numbers::pi;

Material coated(double ior, Microsurface microsurface, Base base) {
    Material material;
    material.name = "test";
    material.layers.push_back({{ior, microsurface}, AbsorbingMedium{}});
    material.base = std::move(base);
    return material;
}

Material bare(Base base) {
    Material material;
    material.name = "test";
    material.base = std::move(base);
    return material;
}

ConductorBase gold(Microsurface microsurface) {
    return {{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}, microsurface};
}

// An index of 0 reflects everything: facets without loss.
ConductorBase lossless(Microsurface microsurface) {
    return {{0, 0, 0}, {0, 0, 0}, microsurface};
}

const LambertianBase kClay{{0.5, 0.3, 0.2}};
const LambertianBase kBlack{{0.0, 0.0, 0.0}};

struct NamedMaterial {
    std::string name;
    Material material;
    double width;              // of its narrowest lobe
    double integrable = 1e-6;  // to what the product of panels integrates it
};

const std::vector<NamedMaterial>& materials() {
    static const std::vector<NamedMaterial> all{
        {"clay", bare(kClay), 1.0},
        {"glaze", coated(1.5, {Ndf::ggx, {0.2, 0.2}}, kClay), 0.2},
        {"thin film of air", coated(0.6, {Ndf::ggx, {0.3, 0.3}}, kClay), 0.3,
         1e-3},  // the cone of total reflection cuts panels
        {"frosted glass", coated(1.5, {Ndf::beckmann, {0.4, 0.4}}, NoBase{}), 0.4},
        {"gold", bare(gold({Ndf::ggx, {0.3, 0.3}})), 0.3},
        {"brushed gold", bare(gold({Ndf::ggx, {0.15, 0.6}})), 0.15},
        {"brushed beckmann", bare(gold({Ndf::beckmann, {0.5, 0.2}})), 0.2},
        {"coated gold", coated(1.5, {Ndf::ggx, {0.2, 0.2}}, gold({Ndf::beckmann, {0.3, 0.3}})),
         0.2},
    };
    return all;
}

const std::vector<double> kCosines{1.0, 0.8, 0.4, 0.1};

TEST(Plain, IsReciprocal) {
    for (const NamedMaterial& entry : materials()) {
        const PlainSurface surface = prepare_plain(entry.material);
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

TEST(Plain, ReflectsOnlyAboveTheSurface) {
    const PlainSurface surface = prepare_plain(materials()[1].material);
    const glm::dvec3 above = test::direction(0.5, 0.0);
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

// Walter et al. 2007, Eq. 20 in the mirror direction: F D / (4 cos^2) G2, where for GGX
// D = 1 / (pi alpha^2) and Lambda = (sqrt(1 + alpha^2 tan^2 theta) - 1) / 2.
TEST(Plain, MirrorDirectionIsTheClosedForm) {
    const double alpha = 0.2;
    const PlainSurface surface = prepare_plain(coated(1.5, {Ndf::ggx, {alpha, alpha}}, kClay));
    const glm::dvec3 wo = test::direction(0.5, 0.0);
    const glm::dvec3 wi{-wo.x, 0.0, wo.z};
    const double tangent_squared = 3.0;
    const double two_lambda = std::sqrt(1 + alpha * alpha * tangent_squared) - 1;
    const double refracted = std::sqrt(1.5 * 1.5 - 0.75);  // eta cos_theta_t
    const double s = (0.5 - refracted) / (0.5 + refracted);
    const double p = (2.25 * 0.5 - refracted) / (2.25 * 0.5 + refracted);
    const double coat =
        0.5 * (s * s + p * p) / (pi * alpha * alpha) / (1 + two_lambda) / (4 * 0.25);
    const glm::dvec3 f = eval(surface, wi, wo);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(f[c], coat + kClay.albedo[static_cast<std::size_t>(c)] / pi, 1e-12);
}

TEST(Plain, BareLambertianIsAlbedoOverPi) {
    const PlainSurface surface = prepare_plain(bare(kClay));
    EXPECT_FALSE(surface.coat.has_value());
    const glm::dvec3 f = eval(surface, test::direction(0.1, 0.0), test::direction(0.9, 2.0));
    EXPECT_DOUBLE_EQ(f.x, 0.5 / pi);
    EXPECT_EQ(albedo(surface, test::direction(0.1, 0.0)).base, (glm::dvec3{0.5, 0.3, 0.2}));
    EXPECT_EQ(albedo(surface, test::direction(0.1, 0.0)).direct, glm::dvec3{0.0});
}

TEST(Plain, TakesTheTopInterfaceAndTheBaseOnly) {
    Material material = coated(1.5, {Ndf::ggx, {0.2, 0.2}}, kClay);
    const PlainSurface one = prepare_plain(material);
    material.layers[0].medium = AbsorbingMedium{{0.1, 0.1, 0.1}};
    material.layers.push_back({{1.2, Microsurface{Ndf::beckmann, {0.7, 0.7}}}, ScatteringMedium{}});
    const PlainSurface two = prepare_plain(material);
    const glm::dvec3 wi = test::direction(0.6, 1.0);
    const glm::dvec3 wo = test::direction(0.7, 3.0);
    EXPECT_EQ(eval(one, wi, wo), eval(two, wi, wo));
    const PlainSurface facets =
        prepare_plain(bare(DiffuseFacetsBase{kClay.albedo, Microsurface{Ndf::ggx, {0.5, 0.5}}}));
    EXPECT_EQ(eval(facets, wi, wo), eval(prepare_plain(bare(kClay)), wi, wo));
}

// In water, glass of 1.5 has ((1.5 - 1.33) / (1.5 + 1.33))^2, and the index of gold is over 1.33.
TEST(Plain, IndicesAreRelativeToTheExterior) {
    Material material = coated(1.5, {Ndf::ggx, {0.2, 0.2}}, gold({Ndf::ggx, {0.2, 0.2}}));
    material.exterior_ior = 1.33;
    const PlainSurface surface = prepare_plain(material);
    EXPECT_NEAR(fresnel(1.0, surface.coat->eta), std::pow(0.17 / 2.83, 2), 1e-12);
    const double n = 0.143 / 1.33;
    const double k = 3.983 / 1.33;
    EXPECT_NEAR(fresnel(1.0, surface.conductor->eta[0]),
                (std::pow(n - 1, 2) + k * k) / (std::pow(n + 1, 2) + k * k), 1e-12);
}

TEST(Plain, NarrowLobesAreShadedAtTheirLeastWidth) {
    const PlainSurface smooth = prepare_plain(coated(1.5, {Ndf::ggx, {0.0, 0.1}}, NoBase{}));
    EXPECT_EQ(smooth.coat->facets.alpha_x, 1e-3);
    EXPECT_EQ(smooth.coat->facets.alpha_y, 0.1);
}

TEST(Plain, RefusesBlendsByTheirPointer) {
    const Blend blend{Blend::Operator::symmetric,
                      {Stratum{0.5, {}, {}, {}, {}}, Stratum{0.5, {}, {}, {}, {}}}};
    const auto error_of = [](const Material& material) -> std::string {
        try {
            prepare_plain(material);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    Material top = coated(1.5, {}, kClay);
    top.layers[0].interface.roughness = blend;
    EXPECT_EQ(
        error_of(top),
        "material 'test': /layers/0/interface/blend: the model 'plain' cannot shade a blended "
        "microsurface");
    EXPECT_THAT(error_of(bare(ConductorBase{{}, {}, blend})),
                testing::HasSubstr("/base/conductor/blend"));
    EXPECT_THAT(error_of(bare(DiffuseFacetsBase{{}, blend})),
                testing::HasSubstr("/base/diffuse_facets/blend"));
}

// The part of a lobe's samples that end below the horizon: its density goes on there.
double share_below(const Facets& facets, const glm::dvec3& wo, double width) {
    const auto lobe = [&](const glm::dvec3& wi) { return reflection_pdf(facets, wi, wo); };
    // A mirror direction lies above -wo.
    return test::integrate_zone(lobe, pi / 2, pi - std::acos(wo.z), -wo, width);
}

// How often the coat is chosen for wo, by the words of plain.h.
double documented_choice(const PlainSurface& surface, double cosine) {
    if (!surface.coat) return 0.0;
    if (!surface.albedo && !surface.conductor) return 1.0;
    double base = 0.0;
    for (int c = 0; c < 3; ++c)
        base += surface.albedo
                    ? (*surface.albedo)[c] / 3
                    : fresnel(cosine, surface.conductor->eta[static_cast<std::size_t>(c)]) / 3;
    const double coat = fresnel(cosine, surface.coat->eta);
    return std::min(std::max(coat / (coat + base), 0.1), 0.9);
}

TEST(Plain, PdfIntegratesToOneLessWhatEndsBelow) {
    constexpr double kTolerance = 1e-4;
    for (const NamedMaterial& entry : materials())
        for (const double cosine : kCosines) {
            const PlainSurface surface = prepare_plain(entry.material);
            const glm::dvec3 wo = test::direction(cosine, 0.5);
            const double above = test::integrate_hemisphere(
                [&](const glm::dvec3& wi) { return pdf(surface, wi, wo); }, {-wo.x, -wo.y, wo.z},
                entry.width);
            const double choice = documented_choice(surface, cosine);
            double below = 0.0;
            if (surface.coat) below += choice * share_below(surface.coat->facets, wo, entry.width);
            if (surface.conductor)
                below += (1 - choice) * share_below(surface.conductor->facets, wo, entry.width);
            EXPECT_NEAR(above + below, 1.0, kTolerance) << entry.name << " at " << cosine;
        }
}

// The definition: the integral of f cos_theta_i over the hemisphere.
TEST(Plain, AlbedoIsTheIntegralOfEval) {
    for (const NamedMaterial& entry : materials())
        for (const double cosine : kCosines) {
            const PlainSurface surface = prepare_plain(entry.material);
            const glm::dvec3 wo = test::direction(cosine, 0.5);
            const Albedo fractions = albedo(surface, wo);
            for (int c = 0; c < 3; c += 2) {
                const double integral = test::integrate_hemisphere(
                    [&](const glm::dvec3& wi) { return eval(surface, wi, wo)[c] * wi.z; },
                    {-wo.x, -wo.y, wo.z}, entry.width);
                EXPECT_NEAR(fractions.direct[c] + fractions.base[c], integral, entry.integrable)
                    << entry.name << " at " << cosine << ", channel " << c;
            }
        }
}

TEST(Plain, AlbedoSplitsIntoCoatAndBase) {
    const Microsurface rough{Ndf::ggx, {0.3, 0.3}};
    const Albedo both =
        albedo(prepare_plain(coated(1.5, rough, gold(rough))), test::direction(0.4, 0.0));
    const Albedo coat =
        albedo(prepare_plain(coated(1.5, rough, NoBase{})), test::direction(0.4, 0.0));
    const Albedo base = albedo(prepare_plain(bare(gold(rough))), test::direction(0.4, 0.0));
    EXPECT_EQ(both.direct, coat.direct);
    EXPECT_EQ(both.base, base.base);
    EXPECT_EQ(coat.base, glm::dvec3{0.0});
    EXPECT_EQ(base.direct, glm::dvec3{0.0});
}

// The mean of a sample's weights is the albedo. Small roughnesses included, which the quadrature
// over the hemisphere cannot resolve.
TEST(Plain, WeightsAverageToTheAlbedo) {
    constexpr int kSamples = 40'000;
    std::vector<NamedMaterial> all = materials();
    all.push_back({"polished gold", bare(gold({Ndf::ggx, {1e-3, 1e-3}})), 0});
    all.push_back({"polished beckmann", bare(gold({Ndf::beckmann, {1e-3, 0.5}})), 0});
    all.push_back({"varnish", coated(1.5, {Ndf::ggx, {0.0, 0.0}}, kBlack), 0});
    std::mt19937_64 generator(17);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const NamedMaterial& entry : all)
        for (const double cosine : {1.0, 0.7, 0.2, 0.01}) {
            const PlainSurface surface = prepare_plain(entry.material);
            const glm::dvec3 wo = test::direction(cosine, 0.5);
            double sum = 0.0;
            double squares = 0.0;
            for (int i = 0; i < kSamples; ++i) {
                const double weight =
                    sample(surface, wo,
                           {uniform(generator), uniform(generator), uniform(generator)})
                        .weight.y;
                sum += weight;
                squares += weight * weight;
            }
            const double mean = sum / kSamples;
            const double deviation = std::sqrt(std::max(squares / kSamples - mean * mean, 0.0));
            const Albedo fractions = albedo(surface, wo);
            constexpr double kQuadrature = 1e-6;
            EXPECT_NEAR(mean, fractions.direct.y + fractions.base.y,
                        4 * deviation / std::sqrt(kSamples) + kQuadrature)
                << entry.name << " at " << cosine;
        }
}

TEST(Plain, SamplesCarryTheirPdfAndWeight) {
    std::mt19937_64 generator(5);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const NamedMaterial& entry : materials()) {
        const PlainSurface surface = prepare_plain(entry.material);
        for (int i = 0; i < 1000; ++i) {
            const glm::dvec3 wo =
                test::direction(uniform(generator) + 1e-6, 6 * uniform(generator));
            const Sample chosen =
                sample(surface, wo, {uniform(generator), uniform(generator), uniform(generator)});
            EXPECT_NEAR(glm::length(chosen.wi), 1.0, 1e-12);
            EXPECT_EQ(chosen.pdf, pdf(surface, chosen.wi, wo));
            EXPECT_EQ(chosen.pdf > 0.0, chosen.wi.z > 0.0) << entry.name;
            const glm::dvec3 light = eval(surface, chosen.wi, wo) * std::max(chosen.wi.z, 0.0);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(chosen.weight[c] * chosen.pdf, light[c], 1e-12 * (1 + light[c]));
        }
    }
}

// Jacobian of the mirror: D_wo(wm) / (4 dot(wo, wm)) (Walter et al. 2007, Eqs. 14 and 24), also
// where rounding to float makes nearly opposite directions longer or shorter than 1.
TEST(Plain, PdfFollowsTheVisibleNormals) {
    const Facets facets{Ndf::ggx, 0.2, 0.4};
    const glm::dvec3 wo = test::direction(0.3, 0.5);
    const glm::dvec3 wi = test::direction(0.6, 2.5);
    const glm::dvec3 wm = halfway(wi, wo);
    EXPECT_NEAR(reflection_pdf(facets, wi, wo),
                visible_density(facets, wo, wm) / (4 * glm::dot(wo, wm)), 1e-12);
    const glm::dvec3 grazing = test::direction(1e-4, 0.5);
    const glm::dvec3 mirrored{-grazing.x, -grazing.y, grazing.z};
    const double exact = reflection_pdf(facets, mirrored, grazing);
    constexpr double kFloatRounding = 6e-8;
    for (const double scale : {1 - kFloatRounding, 1 + kFloatRounding})
        EXPECT_NEAR(reflection_pdf(facets, mirrored, grazing * scale), exact, 1e-2 * exact);
}

// At normal incidence a glaze over clay reflects 0.04 / (0.04 + 1/3), which exceeds the least
// choice.
TEST(Plain, ChoosesTheCoatAsDocumented) {
    const PlainSurface surface = prepare_plain(materials()[1].material);
    const glm::dvec3 wo{0.0, 0.0, 1.0};
    const double choice = 0.04 / (0.04 + (0.5 + 0.3 + 0.2) / 3);
    const glm::dvec2 point{0.25, 0.5};
    const glm::dvec3 mirrored = reflection_sample(surface.coat->facets, wo, point);
    const glm::dvec3 diffuse = sample(surface, wo, {choice + 1e-9, point.x, point.y}).wi;
    EXPECT_EQ(sample(surface, wo, {choice - 1e-9, point.x, point.y}).wi, mirrored);
    EXPECT_NEAR(diffuse.z, std::sqrt(1 - point.x), 1e-12);  // Malley's method
    // A coat without contrast over nothing that reflects.
    const PlainSurface nothing = prepare_plain(coated(1.0, {Ndf::ggx, {0.2, 0.2}}, kBlack));
    const glm::dvec3 aslant = test::direction(0.3, 0.0);
    EXPECT_NE(sample(nothing, aslant, {0.1 + 1e-9, point.x, point.y}).wi,
              reflection_sample(nothing.coat->facets, aslant, point));
    // Black clay still gets its tenth.
    const PlainSurface black = prepare_plain(coated(1.5, {Ndf::ggx, {0.2, 0.2}}, kBlack));
    EXPECT_NE(sample(black, wo, {0.9 + 1e-9, point.x, point.y}).wi,
              reflection_sample(black.coat->facets, wo, point));
}

// Single reflections of lossless facets lose only what meets a second facet: never a gain.
TEST(Plain, LosslessFacetsNeverGainEnergy) {
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        for (const double alpha : {1e-3, 0.1, 0.5, 1.0})
            for (const double cosine : {1.0, 0.5, 0.1, 0.01}) {
                const PlainSurface surface = prepare_plain(bare(lossless({ndf, {alpha, alpha}})));
                const double reflected = albedo(surface, test::direction(cosine, 0.0)).base.x;
                EXPECT_LE(reflected, 1.0 + 1e-7);
                // Slopes of order alpha hide a part of that order at most where alpha tan(theta) is
                // small.
                if (alpha < 0.1 * cosine) {
                    EXPECT_GT(reflected, 1.0 - alpha / cosine);
                }
            }
}

// A polished surface reflects like a smooth one: the lobe averages F over angles within alpha.
TEST(Plain, PolishedSurfacesReflectFresnelsFraction) {
    const PlainSurface surface =
        prepare_plain(coated(1.5, {Ndf::beckmann, {1e-3, 1e-3}}, NoBase{}));
    for (const double cosine : {1.0, 0.7, 0.4}) {
        constexpr double kCurvature = 10.0;  // of F, and of the masked part, in units of alpha^2
        EXPECT_NEAR(albedo(surface, test::direction(cosine, 0.0)).direct.x, fresnel(cosine, 1.5),
                    kCurvature * 1e-6);
    }
}

}  // namespace
}  // namespace lacquer::reference
