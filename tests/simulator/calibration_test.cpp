// The simulator against an independent simulation, over random interfaces, stacks and blends.
#include "simulator/calibration.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/albedo.h"
#include "simulator/interface.h"
#include "simulator/stack.h"
#include "support/chi_square.h"
#include "support/normal.h"

namespace lacquer::simulator {
namespace {

constexpr std::uint64_t kWalks = 200'000;
constexpr double kSuiteSignificance = 0.01;
constexpr double kPrintedDigits = 1e-6;  // of the expected values

// About as many comparisons as the three tests below make together.
constexpr int kComparisons = 20 * 4 + 20 * 3 + 18 * 4;

// Whether two estimates of one number agree: a two-sided z test at the suite's corrected level.
void expect_same(double mine, double my_error, double theirs, double their_error,
                 const std::string& what) {
    const double error = std::hypot(my_error, their_error) + kPrintedDigits;
    const double limit =
        test::two_sided_z(test::sidak_significance(kSuiteSignificance, kComparisons));
    EXPECT_LT(std::abs(mine - theirs), limit * error)
        << what << ": " << mine << " against " << theirs << ", standard error " << error;
}

TEST(Calibration, Interfaces) {
    for (const auto& expected : calibration::kInterfaces) {
        const InterfaceEstimate result =
            estimate_interface({Ndf::ggx, expected.alpha, expected.alpha}, expected.eta,
                               expected.tau, expected.cos_theta, {kWalks, 1, {}});
        const std::string what =
            "eta " + std::to_string(expected.eta) + " alpha " + std::to_string(expected.alpha);
        expect_same(result.t_down.mean, result.t_down.standard_error, expected.t_down,
                    expected.t_down_error, "T01 " + what);
        expect_same(result.r_up.mean, result.r_up.standard_error, expected.r_up,
                    expected.r_up_error, "R10 " + what);
        expect_same(result.t_up.mean, result.t_up.standard_error, expected.t_up,
                    expected.t_up_error, "T10 " + what);
        const InterfaceEstimate clear =
            estimate_interface({Ndf::ggx, expected.alpha, expected.alpha}, expected.eta, 1.0,
                               expected.cos_theta, {kWalks, 2, {}});
        // Their error of the variance is not stated; their walks were about as many as ours.
        expect_same(clear.variance.mean, clear.variance.standard_error, expected.variance,
                    clear.variance.standard_error, "variance " + what);
    }
}

Material stack_material(const calibration::StackResult& stack) {
    Material material;
    for (const auto& layer : stack.layers)
        material.layers.push_back({{layer.ior, Microsurface{Ndf::ggx, {layer.alpha, layer.alpha}}},
                                   AbsorbingMedium{{layer.tau, layer.tau, layer.tau}}});
    if (stack.albedo >= 0.0) {
        material.base = LambertianBase{{stack.albedo, stack.albedo, stack.albedo}};
    } else {
        material.base = ConductorBase{{stack.eta, stack.eta, stack.eta},
                                      {stack.kappa, stack.kappa, stack.kappa},
                                      Microsurface{Ndf::ggx, {stack.alpha, stack.alpha}}};
    }
    return material;
}

TEST(Calibration, Stacks) {
    int index = 0;
    for (const auto& expected : calibration::kStacks) {
        const StackWalk stack{stack_material(expected)};
        const AlbedoEstimate result = estimate_albedo(stack, expected.cos_theta, {kWalks, 3, {}});
        const std::string what = "stack " + std::to_string(index++);
        expect_same(result.direct.mean[0], result.direct.standard_error[0], expected.direct,
                    expected.direct_error, what + " direct");
        expect_same(result.base.mean[0], result.base.standard_error[0], expected.base,
                    expected.base_error, what + " base");
        expect_same(result.total.mean[0], result.total.standard_error[0], expected.total,
                    expected.total_error, what + " total");
    }
}

FacetMaterial facet_material(calibration::FacetKind kind,
                             const calibration::StratumOfBlend& stratum) {
    if (kind == calibration::FacetKind::dielectric) return DielectricFacet{stratum.eta};
    if (kind == calibration::FacetKind::diffuse)
        return DiffuseFacet{{stratum.albedo, stratum.albedo, stratum.albedo}};
    return ConductorFacet{{stratum.eta, stratum.eta, stratum.eta},
                          {stratum.kappa, stratum.kappa, stratum.kappa}};
}

struct OrderTally {
    Moments orders[3];
    Moments reflected;
    std::uint64_t count = 0;

    void merge(const OrderTally& other) {
        for (int order = 0; order < 3; ++order) orders[order].merge(other.orders[order]);
        reflected.merge(other.reflected);
    }
};

TEST(Calibration, Blends) {
    int index = 0;
    for (const auto& expected : calibration::kBlends) {
        const Ndf ndf = expected.beckmann ? Ndf::beckmann : Ndf::ggx;
        Surface surface;
        surface.op = expected.asymmetric ? Blend::Operator::asymmetric : Blend::Operator::symmetric;
        surface.strata = {{expected.top_weight,
                           {ndf, expected.top.alpha, expected.top.alpha},
                           facet_material(expected.facet, expected.top)},
                          {1.0 - expected.top_weight,
                           {ndf, expected.bottom.alpha, expected.bottom.alpha},
                           facet_material(expected.facet, expected.bottom)}};
        const SurfaceWalk walk{surface};
        const double cosine = expected.cos_theta;
        const Vec3 downwards{std::sqrt(1.0 - cosine * cosine), 0.0, -cosine};
        const auto tally =
            run_walks<OrderTally>({kWalks, 5, {}}, [&](RandomStream& random, OrderTally& sum) {
                const Crossing crossing = walk.cross(downwards, random);
                if (crossing.lost || crossing.below) return;
                sum.reflected.add(crossing.weight.x);
                if (crossing.order <= 3) sum.orders[crossing.order - 1].add(crossing.weight.x);
            });
        const std::string what = "blend " + std::to_string(index++);
        const double theirs[] = {expected.first, expected.second, expected.third};
        for (int order = 0; order < 3; ++order) {
            const double error = tally.orders[order].standard_error(kWalks);
            expect_same(tally.orders[order].mean(kWalks), error, theirs[order],
                        order == 0 ? expected.first_error : error,
                        what + " order " + std::to_string(order + 1));
        }
        expect_same(tally.reflected.mean(kWalks), tally.reflected.standard_error(kWalks),
                    expected.reflected, expected.reflected_error, what + " all orders");
    }
}

}  // namespace
}  // namespace lacquer::simulator
