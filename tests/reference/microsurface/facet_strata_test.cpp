// What can be seen of blended surfaces: against uniform ones, and against the integral over
// heights that the closed forms stand for.
#include "reference/microsurface/facet_strata.h"

#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <numeric>

#include "integrate.h"
#include "reference/microsurface/visible_normals.h"
#include "support/expect_fit.h"
#include "support/sampling_fit.h"

namespace lacquer::reference {
namespace {

using Op = Blend::Operator;

constexpr Facets kSmooth{Ndf::ggx, 0.2, 0.2};
constexpr Facets kSmoother{Ndf::ggx, 0.4, 0.4};  // as narrow as chi-square's midpoints can be
constexpr Facets kRough{Ndf::beckmann, 0.9, 0.5};
constexpr Facets kRoughest{Ndf::ggx, 1.0, 1.0};

FacetStrata three(Op op) {
    return {op, {{0.3, kRough}, {0.5, kSmooth}, {0.2, kRoughest}}};
}

double sum(const StratumShares& shares) {
    return std::accumulate(shares.begin(), shares.end(), 0.0);
}

const std::vector<glm::dvec3>& directions() {
    static const std::vector<glm::dvec3> all{test::direction(1.0, 0.0), test::direction(0.7, 0.4),
                                             test::direction(0.5, 2.8), test::direction(0.08, -1.0),
                                             test::direction(1e-4, 1.9)};
    return all;
}

TEST(FacetStrata, BlendsAreLinearInTheWeights) {
    const FacetStrata surface = three(Op::symmetric);
    for (const glm::dvec3& w : directions()) {
        const double expected =
            0.3 * lambda(kRough, w) + 0.5 * lambda(kSmooth, w) + 0.2 * lambda(kRoughest, w);
        EXPECT_NEAR(lambda(surface, w), expected, 1e-12 * expected);
        EXPECT_NEAR(projected_area(surface, w), w.z * (1.0 + expected), 1e-12);
        const double normals =
            0.3 * density(kRough, w) + 0.5 * density(kSmooth, w) + 0.2 * density(kRoughest, w);
        EXPECT_NEAR(density(surface, w), normals, 1e-12 * normals);
    }
}

// Of whatever weights: one surface is the same however it is cut.
TEST(FacetStrata, EqualStrataAreAUniformSurface) {
    for (const Op op : {Op::symmetric, Op::asymmetric}) {
        const FacetStrata surface{op, {{0.1, kRough}, {0.65, kRough}, {0.25, kRough}}};
        for (const glm::dvec3& wi : directions())
            for (const glm::dvec3& wo : directions()) {
                const double li = lambda(kRough, wi), lo = lambda(kRough, wo);
                EXPECT_NEAR(sum(masking(surface, wo)), masking(kRough, wo), 1e-12);
                const double both = masking_shadowing(kRough, wi, wo);
                EXPECT_NEAR(sum(masking_shadowing(surface, wi, wo)), both, 1e-12 * both);
                const double through = std::exp(std::lgamma(1.0 + li) + std::lgamma(1.0 + lo) -
                                                std::lgamma(2.0 + li + lo));
                EXPECT_NEAR(sum(masking_through(surface, wo, wi)), through, 1e-6 * through);
            }
    }
}

// The share of the surface between heights 0 and 1 that rays leave, upwards in `lambdas_up` (the
// sum of those of all rays upwards) and downwards, passing the strata between.
StratumShares by_height(const FacetStrata& surface, const std::vector<double>& lambdas_up,
                        const std::vector<double>& lambdas_down) {
    using Quadrature = boost::math::quadrature::gauss_kronrod<double, 31>;
    std::vector<double> floors{1.0};
    for (const FacetStratum& stratum : surface.strata)
        floors.push_back(std::max(floors.back() - stratum.weight, 0.0));
    floors.back() = 0.0;
    StratumShares shares;
    for (std::size_t k = 0; k < surface.strata.size(); ++k) {
        const auto visible = [&](double c) {
            double log_visible = 0.0;
            for (std::size_t j = 0; j < surface.strata.size(); ++j) {
                const double low = std::max(floors[j + 1], c), high = std::min(floors[j], c);
                if (low < floors[j]) log_visible += lambdas_up[j] * std::log(low / floors[j]);
                if (high > floors[j + 1])
                    log_visible += lambdas_down[j] * std::log((1.0 - high) / (1.0 - floors[j + 1]));
            }
            return std::exp(log_visible);
        };
        shares.push_back(Quadrature::integrate(visible, floors[k + 1], floors[k], 15, 1e-13));
    }
    return shares;
}

std::vector<double> lambdas(const FacetStrata& surface, const glm::dvec3& w) {
    std::vector<double> all;
    for (const FacetStratum& stratum : surface.strata) all.push_back(lambda(stratum.facets, w));
    return all;
}

void expect_equal(const StratumShares& shares, const StratumShares& expected) {
    ASSERT_EQ(shares.size(), expected.size());
    for (std::size_t k = 0; k < shares.size(); ++k)
        EXPECT_NEAR(shares[k], expected[k], 1e-9 * expected[k] + 1e-13) << "stratum " << k;
}

TEST(FacetStrata, AsymmetricBlendsAreSeenAsTheirHeightsAre) {
    const FacetStrata surface = three(Op::asymmetric);
    const std::vector<double> none(3, 0.0);
    for (const glm::dvec3& wi : directions())
        for (const glm::dvec3& wo : directions()) {
            if (wi.z < 0.01 || wo.z < 0.01) continue;  // beyond this quadrature
            const std::vector<double> up = lambdas(surface, wo), other = lambdas(surface, wi);
            std::vector<double> both = up;
            for (std::size_t k = 0; k < 3; ++k) both[k] += other[k];
            expect_equal(masking(surface, wo), by_height(surface, up, none));
            expect_equal(masking_shadowing(surface, wi, wo), by_height(surface, both, none));
            expect_equal(masking_through(surface, wo, wi), by_height(surface, up, other));
        }
}

// d'Eon et al. 2023, Eqs. 15 and 19 as printed, for two strata.
TEST(FacetStrata, TwoStrataAreThoseOfThePaper) {
    const double w_a = 0.35, w_b = 0.65;
    const FacetStrata surface{Op::asymmetric, {{w_a, kRough}, {w_b, kSmooth}}};
    for (const glm::dvec3& wi : directions())
        for (const glm::dvec3& wo : directions()) {
            const double g_a = masking_shadowing(kRough, wi, wo);
            const double g_b = masking_shadowing(kSmooth, wi, wo);
            const double below = std::pow(w_b, 1.0 / g_a);
            expect_equal(masking_shadowing(surface, wi, wo), {(1.0 - below) * g_a, below * g_b});
        }
}

TEST(FacetStrata, MaskingThroughTurnsOver) {
    const FacetStrata surface = three(Op::asymmetric);
    const FacetStrata other = turned_over(surface);
    for (const glm::dvec3& above : directions())
        for (const glm::dvec3& below : directions()) {
            StratumShares turned = masking_through(other, below, above);
            std::ranges::reverse(turned);
            expect_equal(masking_through(surface, above, below), turned);
        }
}

TEST(FacetStrata, VisibleNormalsHaveTheirProjectedArea) {
    for (const Op op : {Op::symmetric, Op::asymmetric})
        for (const glm::dvec3& w : directions()) {
            const FacetStrata surface = three(op);
            const StratumShares visible = masking(surface, w);
            double area = 0.0;  // over cos_theta
            for (std::size_t k = 0; k < visible.size(); ++k)
                area += visible[k] * (1.0 + lambda(surface.strata[k].facets, w));
            EXPECT_NEAR(area, 1.0, 1e-12);
        }
}

TEST(FacetStrata, SamplingFollowsTheVisibleDensity) {
    constexpr double kSignificance = 0.01 / 6;
    for (const Op op : {Op::symmetric, Op::asymmetric})
        for (const double cosine : {1.0, 0.6, 0.25}) {
            const FacetStrata surface{op, {{0.3, kRough}, {0.5, kSmoother}, {0.2, kRoughest}}};
            const glm::dvec3 w = test::direction(cosine, 0.7);
            test::expect_sampling_fit(
                [&](const glm::dvec3& u) { return sample_visible_normal(surface, w, u).wm; },
                [&](const glm::dvec3& wm) { return visible_density(surface, w, wm); },
                kSignificance, "from " + std::to_string(cosine));
        }
}

}  // namespace
}  // namespace lacquer::reference
