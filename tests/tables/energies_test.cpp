// The committed tables: identities that hold whatever the compression, closed forms, simulation.
#include "tables/energy_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"
#include "simulator/facet_material.h"
#include "simulator/goniophotometer.h"
#include "simulator/interface.h"
#include "simulator/microsurface.h"

namespace lacquer {

namespace {

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

// What the tables promise over their whole range (tables/README.md).
constexpr double kMaxError = 0.01;

}  // namespace

TEST(Energies, NoLightIsLostOverAWhiteBase) {
    // FGD + T01 T10 / (1 - R10) = 1 for a clear coat, by construction: up to rounding.
    for (const double eta : {0.4, 0.8, 1.0, 1.5, 2.7})
        for (const double alpha : {0.0, 0.1, 0.7})
            for (const double cosine : {0.1, 0.6, 1.0}) {
                const double base = tables().t_down(cosine, alpha, eta, 1.0) *
                                    tables().t_up(alpha, eta, 1.0) /
                                    (1.0 - tables().r_up(alpha, eta, 1.0));
                EXPECT_NEAR(tables().fgd_dielectric(cosine, alpha, eta) + base, 1.0, 1e-12);
            }
}

TEST(Energies, AverageIsTheIntegralOfTheProfile) {
    constexpr int kSteps = 20000;
    for (const double eta : {0.35, 0.77, 1.2, 2.9}) {
        const TransmissionProfile profile = tables().t_down_profile(0.3, eta, 0.6);
        double energy = 0.0, spread = 0.0;
        for (int n = 0; n < kSteps; ++n) {
            const double cosine = (n + 0.5) / kSteps;
            const double light = 2.0 * profile.at(cosine) * cosine / kSteps;
            energy += light;
            spread += 0.5 * light * (1.0 - cosine * cosine);
        }
        // The profile is clamped to [0, 1] where compression leaves it, the average is not.
        constexpr double kClamping = 1e-3;
        EXPECT_NEAR(profile.average(), energy, kClamping);
        EXPECT_NEAR(profile.variance(), spread / energy, 3.0 * kClamping);
    }
}

TEST(Energies, SmoothInterfacesFollowFresnel) {
    // Off by kMaxError at most, or as far to the side: next to a critical angle the slope of
    // Fresnel's equations is infinite.
    constexpr double kSideways = 1e-3;  // of the cosine
    const auto transmitted = [](double cosine, double eta) {
        return 1.0 - simulator::dielectric_reflectance(std::clamp(cosine, 0.0, 1.0), eta);
    };
    const auto expect_close = [&](double value, double cosine, double eta) {
        EXPECT_GE(value, transmitted(cosine - kSideways, eta) - kMaxError) << eta << " " << cosine;
        EXPECT_LE(value, transmitted(cosine + kSideways, eta) + kMaxError) << eta << " " << cosine;
    };
    for (const double eta : {0.35, 0.6, 0.9, 1.1, 1.5, 2.8})
        for (int n = 0; n <= 200; ++n) {
            const double cosine = n / 200.0;
            expect_close(tables().t_down(cosine, 0.0, eta, 1.0), cosine, eta);
            expect_close(tables().tir(cosine, 0.0, eta), cosine, eta);
        }
}

TEST(Energies, SmoothDiffuseReflectance) {
    // Closed form for eta 1.5 (theory of Fresnel averages): 0.59635.
    EXPECT_NEAR(tables().r_up(0.0, 1.5, 1.0), 0.59635, 0.003);
}

TEST(Energies, NothingCrossesAnOpaqueMedium) {
    EXPECT_EQ(tables().t_down(0.7, 0.2, 1.5, 0.0), 0.0);
    EXPECT_EQ(tables().t_up(0.2, 1.5, 0.0), 0.0);
}

TEST(Energies, SmoothMirrorsReflectEverythingOnce) {
    EXPECT_EQ(tables().mirror_single(0.4, 0.0), 1.0);
    EXPECT_NEAR(tables().mirror_single_average(0.0), 1.0, 1e-3);
}

TEST(Energies, ClearProfilesAreThoseOfClearMedia) {
    // Sixteen coefficients of at most 1 or so, each rounded to half at four nodes: they add up to
    // less than this anywhere.
    constexpr double kHalves = 1e-3;
    for (const double eta : {0.34, 0.6, 0.97, 0.9999, 1.0, 1.0001, 1.03, 1.46, 2.1, 2.99})
        for (const double alpha : {0.0, 0.003, 0.05, 0.2, 0.61, 1.0}) {
            const DirectionPolynomial exact = tables().t_down_profile(alpha, eta, 1.0).polynomial();
            const DirectionPolynomial clear = tables().clear_profile(alpha, eta);
            EXPECT_EQ(clear.critical, exact.critical);
            for (int n = 0; n <= 400; ++n) {
                const double cosine = n / 400.0;
                EXPECT_NEAR(clear.at(cosine), exact.at(cosine), kHalves) << eta << " " << alpha;
            }
        }
}

TEST(Energies, ClearProfilesAreOfHalvesAtTheNodes) {
    // Alpha 0 and the first eta are nodes: nothing is interpolated.
    for (const double eta : {1.0 - 1e-4, 1.0 + 1e-4})
        for (const Coefficients& side :
             {tables().clear_profile(0.0, eta).below, tables().clear_profile(0.0, eta).above})
            for (const double coefficient : side)
                EXPECT_EQ(coefficient, std::ldexp(std::nearbyint(std::ldexp(coefficient, 24)), -24))
                    << "halves are multiples of 2^-24";
}

TEST(Energies, SmoothConductorsFollowFresnel) {
    // The materials of people, and the largest index that the tables hold. At grazing angles, where
    // good conductors bend within a degree, polynomials are off by several times kMaxError.
    constexpr double kGrazing = 0.03;
    for (const auto& [eta, kappa] :
         {std::pair{0.143, 3.983}, std::pair{0.27, 2.77}, std::pair{1.67, 1.94},
          std::pair{2.9, 3.06}, std::pair{1.5, 0.5}, std::pair{5.0, 10.0}})
        for (int n = 0; n <= 200; ++n) {
            const double cosine = n / 200.0;
            const double truth = simulator::conductor_reflectance(cosine, eta, kappa);
            EXPECT_NEAR(tables().fgd_conductor(cosine, 0.0, eta, kappa), truth,
                        cosine < 0.1 ? kGrazing : kMaxError)
                << eta << " " << kappa << " " << cosine;
        }
}

TEST(Energies, ConductorsAreTheirProfilesClamped) {
    for (const double alpha : {0.0, 0.1, 0.9})
        for (const double cosine : {0.0, 0.3, 1.0}) {
            const DirectionPolynomial profile = tables().fgd_conductor_profile(alpha, 0.2, 3.9);
            EXPECT_EQ(profile.critical, 0.0);
            EXPECT_EQ(tables().fgd_conductor(cosine, alpha, 0.2, 3.9),
                      std::clamp(profile.at(cosine), 0.0, 1.0));
        }
}

TEST(Energies, LobesOfSmoothMirrorsAreRays) {
    for (const double cosine : {0.0, 0.013, 0.5, 1.0}) {
        const LobeNodes nodes = tables().lobe(cosine, 0.0);
        for (const double node : nodes.cosines) EXPECT_EQ(node, cosine);
        EXPECT_EQ(nodes.single, 1.0);
    }
}

TEST(Energies, LobeNodesRise) {
    for (int a = 0; a <= 50; ++a)
        for (int c = 0; c <= 50; ++c) {
            const LobeNodes nodes = tables().lobe(c / 50.0, a / 50.0);
            EXPECT_TRUE(std::ranges::is_sorted(nodes.cosines)) << a << " " << c;
            EXPECT_GE(nodes.cosines.front(), 0.0);
            EXPECT_LE(nodes.cosines.back(), 1.0);
        }
}

TEST(Energies, LobesKeepWhatMirrorsKeepOnce) {
    for (const double alpha : {0.02, 0.15, 0.5, 1.0})
        for (const double cosine : {0.02, 0.1, 0.4, 0.8, 1.0})
            EXPECT_NEAR(tables().lobe(cosine, alpha).single, tables().mirror_single(cosine, alpha),
                        kMaxError)
                << alpha << " " << cosine;
}

TEST(Energies, ArgumentsOutsideTheRangesAreErrors) {
    EXPECT_THROW(tables().t_down(0.5, 1.5, 1.5, 1.0), Error);
    EXPECT_THROW(tables().t_down(0.5, 0.5, 3.5, 1.0), Error);
    EXPECT_THROW(tables().t_down(0.5, 0.5, 1.5, -0.1), Error);
    EXPECT_THROW(tables().t_down(std::nan(""), 0.5, 1.5, 1.0), Error);
    EXPECT_THROW(tables().fgd_conductor(0.5, 0.5, 6.0, 1.0), Error);
}

TEST(Energies, TablesOfOtherShapesAreRefused) {
    const auto good = read_tables(BAKED_TABLES);
    EXPECT_NO_THROW(EnergyTables{good});
    for (std::size_t n = 0; n < good.size(); ++n) {
        auto damaged = good;
        std::swap(damaged[n].arrays[0].axes.front(), damaged[n].arrays[0].axes.back());
        EXPECT_THROW(EnergyTables{damaged}, Error) << kTableNames[n];
        damaged = good;
        damaged[n].arrays.erase(damaged[n].arrays.begin());
        EXPECT_THROW(EnergyTables{damaged}, Error) << kTableNames[n];
    }
}

TEST(Energies, AllTablesFitTheirBudget) {
    EXPECT_LE(tables().bytes(), 128u * 1024u);
}

namespace {

using simulator::SurfaceWalk;

// Share of walks onto GGX facets that `counts`, weighted by what they carry, with its error.
template <typename Counts>
simulator::Estimate share_of_walks(double cosine, double alpha,
                                   const simulator::FacetMaterial& material, const Counts& counts) {
    struct Tally : simulator::Moments {
        std::uint64_t count = 0;
    };
    simulator::RunOptions options;
    options.samples = 100'000;
    const SurfaceWalk surface{
        {Blend::Operator::asymmetric, {{1.0, {Ndf::ggx, alpha, alpha}, material}}}};
    const simulator::Vec3 arriving{std::sqrt(1.0 - cosine * cosine), 0.0, -cosine};
    const auto tally =
        simulator::run_walks<Tally>(options, [&](simulator::RandomStream& random, Tally& sum) {
            const simulator::Crossing crossing = surface.cross(arriving, random);
            if (!crossing.lost && counts(crossing)) sum.add(crossing.weight.x);
        });
    const auto count = static_cast<double>(tally.count);
    return {tally.mean(count), tally.standard_error(count)};
}

void expect_near(double value, const simulator::Estimate& truth, const char* what) {
    EXPECT_NEAR(value, truth.mean, kMaxError + 4.0 * truth.standard_error) << what;
}

}  // namespace

TEST(Energies, OfFacetsAgreeWithTheSimulator) {
    struct Point {
        double cosine, alpha, eta, kappa;
    };
    for (const auto& [cosine, alpha, eta, kappa] :
         {Point{0.9, 0.2, 0.2, 3.4}, Point{0.3, 0.7, 1.6, 8.0}, Point{0.6, 1.0, 2.8, 3.1}}) {
        const simulator::ConductorFacet metal{{eta, eta, eta}, {kappa, kappa, kappa}};
        const simulator::ConductorFacet mirror{};  // index 0 reflects everything
        const auto any = [](const simulator::Crossing& crossing) { return !crossing.below; };
        const auto once = [](const simulator::Crossing& crossing) { return crossing.order == 1; };
        const auto again = [](const simulator::Crossing& crossing) {
            return !crossing.below && crossing.order > 1;
        };
        expect_near(tables().fgd_conductor(cosine, alpha, eta, kappa),
                    share_of_walks(cosine, alpha, metal, any), "conductor");
        expect_near(tables().mirror_single(cosine, alpha),
                    share_of_walks(cosine, alpha, mirror, once), "mirror");
        for (const double ratio : {0.6, 1.5})
            expect_near(tables().fgd_multiple(cosine, alpha, ratio),
                        share_of_walks(cosine, alpha, simulator::DielectricFacet{ratio}, again),
                        "multiple");
    }
}

namespace {

// What mirrors send back at their first facet, walk by walk, and for all other walks an even
// spread of diffuse light: cosines in rising order.
std::vector<double> mirrored_cosines(double cosine, double alpha) {
    constexpr int kWalks = 100'000;
    const simulator::FacetMaterial mirror = simulator::ConductorFacet{};
    const SurfaceWalk surface{
        {Blend::Operator::asymmetric, {{1.0, {Ndf::ggx, alpha, alpha}, mirror}}}};
    const simulator::Vec3 arriving{std::sqrt(1.0 - cosine * cosine), 0.0, -cosine};
    simulator::RandomStream random{1, 1};
    std::vector<double> cosines;
    for (int n = 0; n < kWalks; ++n) {
        const simulator::Crossing crossing = surface.cross(arriving, random);
        if (!crossing.lost && crossing.order == 1) cosines.push_back(crossing.direction.z);
    }
    const int diffuse = kWalks - static_cast<int>(cosines.size());
    for (int n = 0; n < diffuse; ++n) cosines.push_back(std::sqrt((n + 0.5) / diffuse));
    std::ranges::sort(cosines);
    return cosines;
}

}  // namespace

TEST(Energies, LobesAgreeWithTheSimulator) {
    for (const double alpha : {0.05, 0.3, 0.8})
        for (const double cosine : {0.1, 0.5, 0.95}) {
            const std::vector<double> walks = mirrored_cosines(cosine, alpha);
            const LobeNodes nodes = tables().lobe(cosine, alpha);
            const std::size_t share = walks.size() / kLobeNodes;
            for (std::size_t n = 0; n < kLobeNodes; ++n) {
                double mean = 0.0;
                for (std::size_t walk = n * share; walk < (n + 1) * share; ++walk)
                    mean += walks[walk] / static_cast<double>(share);
                EXPECT_NEAR(nodes.cosines[n], mean, kMaxError) << alpha << " " << cosine;
            }
        }
}

TEST(Energies, EquivalentAlphaHasTheVarianceOfItsLobe) {
    for (const double alpha : {0.05, 0.2, 0.5, 0.9}) {
        Material material;
        material.base = ConductorBase{{}, {}, Microsurface{Ndf::ggx, {alpha, alpha}}};
        simulator::RunOptions options;
        options.samples = 1'000'000;
        const auto lobe = simulator::estimate_distribution(simulator::StackWalk{material, {1}},
                                                           {0.0, 0.0, 1.0}, {}, options);
        const double variance = lobe.base.variance_x.mean[0] + lobe.direct.variance_x.mean[0];
        // Near 1 a lobe hardly widens any more: its variance changes by 0.05 per unit of alpha, so
        // that the noise of the variance, 0.0004, is one of 0.008, and nodes are 0.07 apart.
        constexpr double kSteep = 0.025;
        EXPECT_NEAR(tables().equivalent_alpha(variance), alpha, kSteep);
    }
}

TEST(Energies, AgreeWithTheSimulator) {
    // The simulator shares no code with what baked the tables.
    struct Point {
        double alpha, eta, tau, cosine;
    };
    for (const auto [alpha, eta, tau, cosine] :
         {Point{0.05, 0.6, 0.7, 0.9}, Point{0.4, 0.8, 1.0, 0.5}, Point{0.2, 1.3, 0.5, 0.3},
          Point{0.8, 1.6, 0.9, 0.7}, Point{0.5, 2.5, 0.2, 0.95}}) {
        simulator::RunOptions options;
        options.samples = 200'000;
        const auto truth =
            simulator::estimate_interface({Ndf::ggx, alpha, alpha}, eta, tau, cosine, options);
        const auto tolerance = [](const simulator::Estimate& estimate) {
            return kMaxError + 4.0 * estimate.standard_error;
        };
        EXPECT_NEAR(tables().t_down(cosine, alpha, eta, tau), truth.t_down.mean,
                    tolerance(truth.t_down));
        EXPECT_NEAR(tables().t_up(alpha, eta, tau), truth.t_up.mean, tolerance(truth.t_up));
        EXPECT_NEAR(tables().r_up(alpha, eta, tau), truth.r_up.mean, tolerance(truth.r_up));
        EXPECT_NEAR(tables().variance(alpha, eta, tau), truth.variance.mean,
                    tolerance(truth.variance));
    }
}

}  // namespace lacquer
