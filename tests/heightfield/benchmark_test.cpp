// The published benchmark: mirrors of Beckmann roughness 0.91 and 0.364, in strata and alone, on
// ray traced surfaces and by Smith's theory. Based on: d'Eon et al. 2023, Microfacet Theory for
// Non-Uniform Heightfields, figure 13
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "heightfield/scattered_light.h"
#include "heightfield/surfaces.h"

namespace lacquer::heightfield {
namespace {

using simulator::FacetStratum;

// Smith's theory takes neighbouring facets as independent; that moves the energy of an order by
// less than this.
constexpr double kTheory = 0.03;
// Standard errors that a correct program exceeds once in 10^4.
constexpr double kErrors = 4.0;

const std::vector<simulator::Vec3> kDirections{test::direction_at(0.75), test::direction_at(1.5)};

struct Effort {
    FieldGrid grid;
    LightOptions light;
    double noise;  // standard errors that are allowed on top of kTheory
};

Effort quick() {
    Effort effort{{384, 6.0}, {}, kErrors};
    effort.light.repetitions = 8;
    effort.light.rays = 1 << 13;
    return effort;
}

// So exact that the surfaces' chance counts for nothing.
Effort thorough() {
    Effort effort{{1024, 16.0}, {}, 0.0};
    effort.light.repetitions = 32;
    effort.light.rays = 1 << 15;
    return effort;
}

void expect_near(const simulator::RgbEstimate& traced, const simulator::RgbEstimate& walked,
                 const Effort& effort, const std::string& what) {
    EXPECT_NEAR(traced.mean[0], walked.mean[0],
                kTheory + effort.noise * (traced.standard_error[0] + walked.standard_error[0]))
        << what;
}

void expect_theory(const std::vector<FacetStratum>& strata, const Effort& effort,
                   const std::string& what) {
    const auto traced = heightfield_light(strata, kDirections, effort.grid, effort.light);
    const auto walked = smith_light(simulator::SurfaceWalk{{Blend::Operator::asymmetric, strata}},
                                    kDirections, effort.light);
    for (std::size_t n = 0; n < kDirections.size(); ++n) {
        for (std::size_t order = 0; order < 3; ++order)
            expect_near(traced[n].orders[order].energy, walked[n].orders[order].energy, effort,
                        fmt::format("{}, direction {}, order {}", what, n, order + 1));
        expect_near(traced[n].transmitted, walked[n].transmitted, effort,
                    fmt::format("{}, direction {}, transmitted", what, n));
    }
}

void expect_theory_everywhere(const Effort& effort) {
    expect_theory(test::uniform(0.91), effort, "0.91");
    expect_theory(test::uniform(0.364), effort, "0.364");
    expect_theory(test::two_strata(0.91, 0.364), effort, "0.91 over 0.364");
    expect_theory(test::two_strata(0.364, 0.91), effort, "0.364 over 0.91");
}

TEST(Benchmark, OrdersAreThoseOfSmithsTheory) {
    expect_theory_everywhere(quick());
}

TEST(BenchmarkFull, OrdersAreThoseOfSmithsTheory) {
    expect_theory_everywhere(thorough());
}

// Diffuse facets scatter on, dielectric ones let light through to the surface's other side, where
// the strata are in the other order.
void expect_other_materials(const Effort& effort) {
    for (const auto& [top, bottom] : {std::pair{0.91, 0.364}, {0.364, 0.91}}) {
        const std::string strata = fmt::format("{} over {}", top, bottom);
        expect_theory(test::two_strata(top, bottom, simulator::DiffuseFacet{{0.8, 0.8, 0.8}}),
                      effort, "diffuse " + strata);
        expect_theory(test::two_strata(top, bottom, simulator::DielectricFacet{1.5}), effort,
                      "dielectric " + strata);
    }
}

TEST(Benchmark, OtherMaterialsFollowTheTheoryToo) {
    expect_other_materials(quick());
}

TEST(BenchmarkFull, OtherMaterialsFollowTheTheoryToo) {
    expect_other_materials(thorough());
}

// What another ray tracer found on Gaussian heightfields at theta 0.75, to three digits: energy of
// orders 1 and 2.
struct OtherTracer {
    std::vector<FacetStratum> strata;
    double first, second;
};

void expect_other_tracer(const Effort& effort) {
    // Its digits and its own noise, unknown but for the digits given; and how coarse facets of 6
    // cells per correlation length are, found by comparing with 32.
    constexpr double kOthers = 0.004;
    for (const auto& [strata, first, second] :
         {OtherTracer{test::two_strata(0.91, 0.364), 0.830, 0.145},
          OtherTracer{test::uniform(0.91), 0.697, 0.260}}) {
        const auto light =
            heightfield_light(strata, {&kDirections.front(), 1}, effort.grid, effort.light);
        const auto expect_order = [&](std::size_t order, double energy) {
            const auto& found = light[0].orders[order].energy;
            EXPECT_NEAR(found.mean[0], energy, kOthers + kErrors * found.standard_error[0]);
        };
        expect_order(0, first);
        expect_order(1, second);
    }
}

TEST(Benchmark, OrdersAreThoseOfAnotherRayTracer) {
    expect_other_tracer(quick());
}

TEST(BenchmarkFull, OrdersAreThoseOfAnotherRayTracer) {
    expect_other_tracer(thorough());
}

}  // namespace
}  // namespace lacquer::heightfield
