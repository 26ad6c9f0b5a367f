// The distributions of facet normals against the integrals that define them.
#include "reference/facets.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/exp_sinh.hpp>
#include <boost/math/quadrature/sinh_sinh.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "integrate.h"
#include "reference/beckmann.h"
#include "support/chi_square.h"
#include "support/expect_fit.h"

namespace lacquer::reference {
namespace {

using std::numbers::pi;

const std::vector<Facets> kFacets{
    {Ndf::ggx, 1.0, 1.0},        {Ndf::ggx, 0.3, 0.3},      {Ndf::ggx, 0.02, 0.02},
    {Ndf::ggx, 0.1, 0.5},        {Ndf::beckmann, 1.0, 1.0}, {Ndf::beckmann, 0.3, 0.3},
    {Ndf::beckmann, 0.02, 0.02}, {Ndf::beckmann, 0.5, 0.1},
};
const std::vector<double> kCosines{1.0, 0.9, 0.5, 0.1, 0.01};
constexpr glm::dvec3 kNormal{0.0, 0.0, 1.0};

std::string describe(const Facets& facets) {
    return (facets.ndf == Ndf::ggx ? "ggx " : "beckmann ") + std::to_string(facets.alpha_x) + " " +
           std::to_string(facets.alpha_y);
}

double narrow(const Facets& facets) {
    return std::min(facets.alpha_x, facets.alpha_y);
}

// Heitz 2014, Eq. 3: facets project onto the area below them.
TEST(Facets, DensityIsNormalised) {
    for (const Facets& facets : kFacets) {
        const auto projected = [&](const glm::dvec3& wm) { return density(facets, wm) * wm.z; };
        EXPECT_NEAR(test::integrate_hemisphere(projected, kNormal, narrow(facets)), 1.0, 1e-6)
            << describe(facets);
    }
}

// Heitz 2014, Eqs. 12 and 16: the visible facets project onto the area seen, so that their density
// integrates to 1. This ties masking to the density.
TEST(Facets, VisibleDensityIsNormalised) {
    // The panels do not follow the great circle beyond which facets turn their backs, where the
    // density has a kink; twice as many of them bring what is left down fourfold.
    constexpr double kKink = 3e-4;
    for (const Facets& facets : kFacets)
        for (const double cosine : kCosines)
            for (const double phi : {0.0, 0.6, pi / 2}) {
                const glm::dvec3 w = test::direction(cosine, phi);
                const auto visible = [&](const glm::dvec3& wm) {
                    return visible_density(facets, w, wm);
                };
                EXPECT_NEAR(test::integrate_hemisphere(visible, kNormal, narrow(facets)), 1.0,
                            kKink)
                    << describe(facets) << " from " << cosine << ", " << phi;
            }
}

// Heitz 2014, Eq. 62: Lambda is the mean overhang of slopes steeper than the direction,
//     Lambda = 1 / cot(theta) * integral over s > cot(theta) of (s - cot(theta)) P(s),
// where P(s) is the density of slopes along the direction, here a numerical integral as well.
TEST(Facets, LambdaIsTheIntegralOfSlopes) {
    boost::math::quadrature::sinh_sinh<double> line;
    boost::math::quadrature::exp_sinh<double> ray;
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        for (const double cot : {0.02, 0.3, 1.0, 2.5}) {
            const auto marginal = [&](double s) {
                return line.integrate(
                    [&](double t) { return slope_density(ndf, std::hypot(s, t)); });
            };
            const double overhang = ray.integrate([&](double s) { return s * marginal(cot + s); });
            const glm::dvec3 w = glm::normalize(glm::dvec3{1.0, 0.0, cot});
            EXPECT_NEAR(lambda({ndf, 1.0, 1.0}, w), overhang / cot, 1e-8 / cot) << cot;
        }
}

TEST(Facets, StretchingScalesSlopesOnly) {
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann}) {
        const Facets brushed{ndf, 0.1, 0.5};
        for (const double cosine : {0.9, 0.3, 0.01}) {
            const glm::dvec3 along_x = test::direction(cosine, 0.0);
            const glm::dvec3 along_y = test::direction(cosine, pi / 2);
            EXPECT_DOUBLE_EQ(lambda(brushed, along_x), lambda({ndf, 0.1, 0.1}, along_x));
            EXPECT_NEAR(lambda(brushed, along_y), lambda({ndf, 0.5, 0.5}, along_y),
                        1e-12 * lambda(brushed, along_y));
        }
        // Slopes are steep along y.
        EXPECT_LT(density(brushed, test::direction(0.9, 0.0)),
                  1e-2 * density(brushed, test::direction(0.9, pi / 2)));
    }
}

// Closed forms: D at its peak is 1 / (pi alpha_x alpha_y) for both.
TEST(Facets, PeakIsThatOfTheTextbooks) {
    for (const Facets& facets : kFacets) {
        const double peak = 1.0 / (pi * facets.alpha_x * facets.alpha_y);
        EXPECT_NEAR(density(facets, kNormal), peak, 1e-12 * peak);
    }
    // Walter et al. 2007, Eqs. 33 and 25, at alpha 0.5 and 45 degrees.
    const glm::dvec3 wm = test::direction(std::sqrt(0.5), 0.3);
    EXPECT_NEAR(density({Ndf::ggx, 0.5, 0.5}, wm), 0.25 / (pi * 0.25 * 1.25 * 1.25), 1e-12);
    EXPECT_NEAR(density({Ndf::beckmann, 0.5, 0.5}, wm), std::exp(-4.0) / (pi * 0.25 * 0.25), 1e-12);
}

TEST(Facets, MaskingHasItsLimits) {
    for (const Facets& facets : kFacets) {
        EXPECT_EQ(masking(facets, kNormal), 1.0);
        EXPECT_LT(masking(facets, test::direction(1e-7, 0.4)), 1e-4) << describe(facets);
        for (const double i : kCosines)
            for (const double o : kCosines) {
                const glm::dvec3 wi = test::direction(i, 0.3);
                const glm::dvec3 wo = test::direction(o, 2.0);
                const double both = masking_shadowing(facets, wi, wo);
                EXPECT_NEAR(both, masking_shadowing(facets, wo, wi), 1e-14);
                EXPECT_LE(both, std::min(masking(facets, wi), masking(facets, wo)));
                EXPECT_GE(both, masking(facets, wi) * masking(facets, wo) * (1 - 1e-12));
            }
    }
}

// The fraction of visible facets with a slope along the view up to the sampled one is u.x, and the
// slope across it is normal with variance 1/2, whose distribution function at the sampled one is
// u.y.
TEST(Beckmann, SamplesByInversion) {
    for (const double cosine : {1.0, 0.8, 0.3, 0.02})
        for (const double u : {0.001, 0.25, 0.5, 0.9, 0.999}) {
            const glm::dvec3 w = test::direction(cosine, 0.0);
            const glm::dvec3 wm = beckmann::sample_visible_normal(w, {u, 1 - u});
            const double along = -wm.x / wm.z;
            const double across = -wm.y / wm.z;
            const auto area = [&](double s) {
                return std::max(w.z - s * w.x, 0.0) * std::exp(-s * s);
            };
            const double last = cosine < 1.0 ? w.z / w.x : 8.0;
            const double all =
                test::integrate_between(area, {-8.0, 0.0, std::min(last, 8.0)}, 1e-12);
            const double part = along > 0.0
                                    ? test::integrate_between(area, {-8.0, 0.0, along}, 1e-12)
                                    : test::integrate_between(area, {-8.0, along}, 1e-12);
            EXPECT_NEAR(part / all, u, 1e-9) << cosine;
            EXPECT_NEAR(0.5 * std::erfc(-across), 1 - u, 1e-12) << cosine;
        }
}

TEST(Beckmann, SamplesStayFiniteAtTheEnds) {
    for (const double cosine : {1.0, 0.5, 1e-3})
        for (const glm::dvec2 u : {glm::dvec2{0.0, 0.0}, glm::dvec2{1 - 1e-16, 1 - 1e-16}}) {
            const glm::dvec3 wm = beckmann::sample_visible_normal(test::direction(cosine, 0.0), u);
            EXPECT_NEAR(glm::length(wm), 1.0, 1e-12);
            EXPECT_GT(wm.z, 0.0);
        }
}

TEST(Facets, SamplingAtNormalIncidenceIgnoresTheSignOfZero) {
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        EXPECT_EQ(sample_visible_normal({ndf, 0.3, 0.5}, {-0.0, -0.0, 1.0}, {0.3, 0.8}),
                  sample_visible_normal({ndf, 0.3, 0.5}, {0.0, 0.0, 1.0}, {0.3, 0.8}));
}

// Cells of equal solid angle: rings of cos_theta, cut into sectors.
constexpr int kRings = 10;
constexpr int kSectors = 12;
constexpr int kSamples = 200'000;

std::vector<double> count_normals(const Facets& facets, const glm::dvec3& w) {
    std::mt19937_64 generator(41);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    std::vector<double> counts(kRings * kSectors);
    for (int i = 0; i < kSamples; ++i) {
        const glm::dvec2 u{uniform(generator), uniform(generator)};
        const glm::dvec3 wm = sample_visible_normal(facets, w, u);
        const double turn = std::atan2(wm.y, wm.x) / (2 * pi) + 0.5;
        const int ring = std::min(static_cast<int>(wm.z * kRings), kRings - 1);
        const int sector = std::min(static_cast<int>(turn * kSectors), kSectors - 1);
        counts[static_cast<std::size_t>(ring * kSectors + sector)] += 1.0;
    }
    return counts;
}

std::vector<double> expect_normals(const Facets& facets, const glm::dvec3& w) {
    std::vector<double> counts;
    for (int ring = 0; ring < kRings; ++ring)
        for (int sector = 0; sector < kSectors; ++sector) {
            const double phi = (static_cast<double>(sector) / kSectors - 0.5) * 2 * pi;
            const auto arc = [&](double z) {
                const auto at = [&](double p) {
                    return visible_density(facets, w, test::direction(z, p));
                };
                return test::Panel::integrate(at, phi, phi + 2 * pi / kSectors);
            };
            const double z = static_cast<double>(ring) / kRings;
            counts.push_back(kSamples * test::Panel::integrate(arc, z, z + 1.0 / kRings));
        }
    return counts;
}

TEST(Facets, SamplingFollowsTheVisibleDensity) {
    constexpr double kSuiteSignificance = 0.01;
    const std::vector<Facets> cases{{Ndf::ggx, 0.3, 0.3},
                                    {Ndf::ggx, 0.2, 0.7},
                                    {Ndf::beckmann, 0.3, 0.3},
                                    {Ndf::beckmann, 0.7, 0.2}};
    const std::vector<double> cosines{1.0, 0.6, 0.1};
    const double significance = test::sidak_significance(
        kSuiteSignificance, static_cast<int>(cases.size() * cosines.size()));
    for (const Facets& facets : cases)
        for (const double cosine : cosines) {
            const glm::dvec3 w = test::direction(cosine, 0.7);
            test::expect_fit(count_normals(facets, w), expect_normals(facets, w), significance,
                             describe(facets) + " from " + std::to_string(cosine));
        }
}

}  // namespace
}  // namespace lacquer::reference
