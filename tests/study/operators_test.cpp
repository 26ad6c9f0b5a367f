// What the figures of operators are made of, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "study/layered/error_sizes.h"
#include "study/layered/operators/lobes.h"
#include "study/layered/operators/operator_plot.h"

namespace lacquer::study {
namespace {

constexpr double kRounding = 1e-12;
constexpr double kSigmas = 4.5;  // of a dozen of numbers: two-sided 8e-5 with Sidak's correction
constexpr std::uint64_t kWalks = 1 << 16;

simulator::RunOptions options() {
    return {kWalks, 5, {}};
}

// Weights 1 and 3 at x = 0.2 and 0.6: mean 0.5, variance of x 0.03, of y 0.
TEST(DiskMoments, OfTwoDirections) {
    DiskMoments moments;
    moments.add(1.0, {0.2, 0.0, 1.0});
    moments.add(3.0, {0.6, 0.0, 1.0});
    const Spread spread = moments.spread(8.0);
    EXPECT_NEAR(spread.energy, 0.5, kRounding);
    EXPECT_NEAR(spread.mean, 0.5, kRounding);
    EXPECT_NEAR(spread.width, std::sqrt(0.5 * 0.03), kRounding);
    // Squared weights times squared residuals: 1 * 0.09 + 9 * 0.01, over the squared sum 16.
    EXPECT_NEAR(spread.mean_error, std::sqrt(0.18) / 4.0, kRounding);
}

TEST(Lobes, OfDiffuseLight) {
    const Spread spread = simulate_spread(options(), [](simulator::RandomStream& random) {
        return Ray{simulator::sample_cosine(random), 1.0};
    });
    EXPECT_EQ(spread.energy, 1.0);
    EXPECT_NEAR(spread.mean, 0.0, kSigmas * spread.mean_error);
    EXPECT_NEAR(spread.width, 0.5, kSigmas * spread.width_error);
    EXPECT_NEAR(spread.mean_error, 0.5 / std::sqrt(double{kWalks}), 0.02 * spread.mean_error);
}

TEST(Lobes, LostRaysCountInTheEnergyAlone) {
    const Spread spread = simulate_spread(options(), [](simulator::RandomStream& random) {
        return Ray{{0.3, 0.0, 0.9}, random.uniform() < 0.25 ? 2.0 : 0.0};
    });
    EXPECT_NEAR(spread.energy, 0.5, kSigmas * spread.energy_error);
    EXPECT_NEAR(spread.mean, 0.3, kRounding);
}

TEST(Lobes, SmoothFacetsMirrorAndRefract) {
    simulator::RandomStream random{1, 1};
    const glm::dvec3 mirrored = mirrors(Ndf::ggx, 0.0).cross(downwards(0.8), random).direction;
    EXPECT_NEAR(mirrored.x, 0.6, kRounding);
    EXPECT_NEAR(mirrored.z, 0.8, kRounding);
    const auto crossing = dielectric(0.0, 1.5).cross(downwards(0.8), random);
    ASSERT_TRUE(crossing.below);
    EXPECT_NEAR(crossing.direction.x, 0.4, kRounding);
}

// Where facets are steep in nothing, the lobe of single reflections is all there is.
TEST(Lobes, QuadratureAndSimulationAgreeOnNarrowOnes) {
    constexpr double kQuadrature = 0.02, kAlpha = 0.05;
    for (const double cosine : {1.0, 0.8}) {
        const simulator::SurfaceWalk surface = mirrors(Ndf::ggx, kAlpha);
        const Spread simulated = simulate_spread(options(), [&](simulator::RandomStream& random) {
            const auto crossing = surface.cross(downwards(cosine), random, 1);
            return Ray{crossing.direction, crossing.lost ? 0.0 : 1.0};
        });
        const Spread lobe = ggx_lobe(kAlpha, cosine);
        EXPECT_NEAR(lobe.width, simulated.width,
                    kQuadrature * lobe.width + kSigmas * simulated.width_error);
        EXPECT_NEAR(lobe.mean, simulated.mean,
                    kQuadrature * lobe.width + kSigmas * simulated.mean_error);
    }
}

TEST(ErrorSizes, TellsTheirDistribution) {
    ErrorSizes errors{"subject", "model"};
    for (int n = 1; n <= 100; ++n) errors.add(n % 2 == 0 ? n : -n, 0.0, [] { return ""; });
    EXPECT_EQ(errors.quantile(0.95), 95.0);
    EXPECT_EQ(errors.quantile(1.0), 100.0);
    EXPECT_EQ(errors.quantile(0.0), 1.0);
    EXPECT_EQ(errors.row(), (std::vector<std::string>{"subject", "model", "50.5000", "95.0000",
                                                      "100.0000", "0.0000"}));
    EXPECT_EQ(errors.row().size(), error_columns("what", "model").size());
}

// Dots where the simulation knows something, a line where the formula is finite, and relative
// errors at the dots.
TEST(OperatorPlot, ShowsAndTallies) {
    OperatorCheck check{"subject", "y", {"x", 0.0, 1.0}, 0.0, 4.0, true, {}};
    check.cases.push_back({"case",
                           [](double x) -> std::optional<Measured> {
                               if (x < 0.5) return std::nullopt;
                               return Measured{2.0, 0.1};
                           },
                           {{"model", [](double x) { return x < 0.25 ? std::nan("") : 3.0; }}}});
    Figure figure;
    NumberTable table = operator_table();
    add_check(figure, table, check, StudyRun{});
    const Plot& plot = std::get<Plots>(figure.panels.front()).plots.front();
    ASSERT_EQ(plot.curves.size(), 2u);
    EXPECT_EQ(plot.curves[0].x.size(), 7u);  // of 13
    EXPECT_EQ(plot.curves[0].errors.front(), 0.1);
    EXPECT_GE(plot.curves[1].x.front(), 0.25);
    ASSERT_EQ(figure.errors.size(), 1u);
    EXPECT_NEAR(figure.errors[0].mean, 0.5, kRounding);
    EXPECT_EQ(table.rows.size(), 1u);
}

}  // namespace
}  // namespace lacquer::study
