// What strata make of energies: shares of light, and polynomials through their sums.
#include "reference/blended_energies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "reference/coated.h"
#include "reference/stack/stack.h"

namespace lacquer::reference {
namespace {

constexpr double kRounding = 1e-12;

Blend two_strata(Blend::Operator op, double upper, double lower) {
    return {op,
            {{0.4, {Ndf::ggx, {upper, upper}}, {}, {}, {}},
             {0.6, {Ndf::ggx, {lower, lower}}, {}, {}, {}}}};
}

FacetStrata strata(Blend::Operator op, double upper, double lower) {
    return isotropic_strata(two_strata(op, upper, lower), {upper, lower});
}

double lambda_of(double alpha, double cosine) {
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 / (cosine * cosine) - 1.0)) - 1.0);
}

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

// d'Eon et al. 2023, section 3.3.2: w_B^(1 + Lambda_A) of the rays pass the top stratum; seen from
// below the strata change places.
TEST(BlendedEnergies, LightMeetsStrataInTheirOrder) {
    const FacetStrata surface = strata(Blend::Operator::asymmetric, 0.5, 0.1);
    for (const double cosine : {0.1, 0.5, 1.0}) {
        EXPECT_NEAR(first_met_at(surface, cosine)[1], std::pow(0.6, 1.0 + lambda_of(0.5, cosine)),
                    kRounding);
        EXPECT_NEAR(first_met_from_below(surface, cosine)[0],
                    std::pow(0.4, 1.0 + lambda_of(0.1, cosine)), kRounding);
    }
}

// Eq. 10: in proportion to the projected areas.
TEST(BlendedEnergies, LightMeetsMixedStrataByTheirProjectedArea) {
    const FacetStrata surface = strata(Blend::Operator::symmetric, 0.5, 0.1);
    const double upper = 0.4 * (1.0 + lambda_of(0.5, 0.3));
    const double lower = 0.6 * (1.0 + lambda_of(0.1, 0.3));
    EXPECT_NEAR(first_met_at(surface, 0.3)[0], upper / (upper + lower), kRounding);
    EXPECT_NEAR(first_met_from_below(surface, 0.3)[0], upper / (upper + lower), kRounding);
}

TEST(BlendedEnergies, SharesAddUpToOne) {
    const FacetStrata surface = strata(Blend::Operator::asymmetric, 0.02, 0.9);
    for (const double cosine : {0.0, 1e-5, 0.3, 1.0}) {
        const StratumShares first = first_met_at(surface, cosine);
        EXPECT_NEAR(std::accumulate(first.begin(), first.end(), 0.0), 1.0, kRounding);
    }
    const StratumShares diffuse = first_met_by_diffuse_light(surface);
    EXPECT_NEAR(diffuse[0] + diffuse[1], 1.0, kRounding);
}

// Shares of strata as different as these bend more near grazing than eight polynomials do: by
// 0.0055 at most.
TEST(BlendedEnergies, PolynomialsFollowTheirSum) {
    constexpr double kFit = 0.006;
    for (const double eta : {0.7, 1.5})
        for (const auto op : {Blend::Operator::asymmetric, Blend::Operator::symmetric}) {
            const FacetStrata surface = strata(op, 0.5, 0.05);
            const std::vector<DirectionPolynomial> both{tables().clear_profile(0.5, eta),
                                                        tables().clear_profile(0.05, eta)};
            const DirectionPolynomial one = blended(surface, both);
            for (double cosine = 0.02; cosine <= 1.0; cosine += 0.02) {
                const StratumShares first = first_met_at(surface, cosine);
                EXPECT_NEAR(one.at(cosine),
                            first[0] * both[0].at(cosine) + first[1] * both[1].at(cosine), kFit)
                    << eta << " " << cosine;
            }
        }
}

// Strata that are all alike are a uniform interface, in every model that takes blends.
TEST(BlendedEnergies, EqualStrataAreAUniformInterface) {
    Material uniform;
    uniform.layers = {
        {{1.5, Microsurface{Ndf::ggx, {0.3, 0.3}}}, AbsorbingMedium{{0.5, 0.8, 1.0}}}};
    uniform.base = LambertianBase{{0.3, 0.6, 0.9}};
    Material blended = uniform;
    blended.layers[0].interface.roughness = two_strata(Blend::Operator::asymmetric, 0.3, 0.3);
    const glm::dvec3 wi{0.6, 0.0, 0.8}, wo{-0.48, 0.64, 0.6};
    // R10_bar, T10_bar and the average of m are from tables of their own where the interface is
    // uniform, which are as far off the integrals of polynomials.
    constexpr double kTables = 2e-3, kTableOfAverages = 1e-5;
    const auto stack = [&](const Material& material) {
        return eval(prepare_stack(material, tables()), wi, wo);
    };
    const auto coated = [&](const Material& material) {
        return eval(prepare_coated(material, tables(), BaseLobe::exact), wi, wo);
    };
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(stack(blended)[c], stack(uniform)[c], kTableOfAverages);
        EXPECT_NEAR(coated(blended)[c], coated(uniform)[c], kTables);
    }
    uniform.base =
        ConductorBase{{0.2, 0.9, 1.5}, {3.9, 2.4, 2.3}, Microsurface{Ndf::beckmann, {0.2, 0.2}}};
    blended.base = uniform.base;
    Blend metal = two_strata(Blend::Operator::symmetric, 0.2, 0.2);
    for (Stratum& stratum : metal.strata) stratum.microsurface.ndf = Ndf::beckmann;
    std::get<ConductorBase>(blended.base).roughness = metal;
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(stack(blended)[c], stack(uniform)[c], kTableOfAverages);
}

}  // namespace
}  // namespace lacquer::reference
