// Light and its time reversal take the same paths: how much light goes from one cell of directions
// to another is the same both ways, up to the square of the index ratio across a material.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "simulator/goniophotometer.h"
#include "simulator/next_event.h"
#include "support/chi_square.h"
#include "support/expect_fit.h"
#include "support/normal.h"

namespace lacquer::simulator {
namespace {

constexpr double kSuiteSignificance = 0.01;
constexpr int kTests = 7 + 3 + 20;  // comparisons of this file
constexpr std::uint64_t kWalks = 400'000;

const HemisphereGrid kGrid{3, 8};
const std::size_t kCells = kGrid.cell_count();

// Energy that goes from cell to cell, for light that arrives from all directions in proportion to
// the cosine.
struct TransferTally {
    std::vector<Moments> reflected = std::vector<Moments>(kCells * kCells);
    std::vector<Moments> crossed = std::vector<Moments>(kCells * kCells);
    std::uint64_t count = 0;

    void merge(const TransferTally& other) {
        for (std::size_t pair = 0; pair < reflected.size(); ++pair) {
            reflected[pair].merge(other.reflected[pair]);
            crossed[pair].merge(other.crossed[pair]);
        }
    }
};

TransferTally transfer(const Material& material, bool from_below, std::uint64_t seed) {
    const StackWalk stack{material};
    return run_walks<TransferTally>(
        {kWalks, seed, {}},
        [&](RandomStream& random, TransferTally& sum) {
            Vec3 from = sample_cosine(random);
            if (from_below) from = -from;
            const Exit exit =
                from_below ? stack.walk_from_below(from, random) : stack.walk(from, random);
            if (exit.fate == Fate::lost) return;
            const std::size_t pair = kGrid.cell(from) * kCells + kGrid.cell(exit.direction);
            const bool crossed = (exit.fate == Fate::transmitted) != from_below;
            (crossed ? sum.crossed : sum.reflected)[pair].add(exit.weight.y);
        },
        1 << 15);
}

// Chi-square of the differences between what goes one way and what goes the other. A pair of cells
// counts where enough light passes for its sum to be normal.
void expect_equal(const std::vector<Moments>& forth, const std::vector<Moments>& back, double scale,
                  const std::string& what) {
    constexpr double kMinSum = 40.0;
    test::ChiSquare fit;
    test::CsvColumn sums_forth{"forth", {}}, sums_back{"back", {}};
    for (std::size_t a = 0; a < kCells; ++a)
        for (std::size_t b = 0; b < kCells; ++b) {
            const Moments& one = forth[a * kCells + b];
            const Moments& other = back[b * kCells + a];
            if (&one >= &other && &forth == &back) continue;  // each pair once
            if (one.sum + other.sum < kMinSum) continue;
            const double difference = one.sum - scale * other.sum;
            fit.statistic +=
                difference * difference / (one.squares + scale * scale * other.squares);
            ++fit.degrees_of_freedom;
            sums_forth.values.push_back(one.sum);
            sums_back.values.push_back(scale * other.sum);
        }
    EXPECT_GT(fit.degrees_of_freedom, 50) << what;
    if (fit.p_value() > test::sidak_significance(kSuiteSignificance, kTests)) return;
    ADD_FAILURE() << what << ": chi-square " << fit.statistic << " at " << fit.degrees_of_freedom
                  << " degrees of freedom; pairs of cells in "
                  << test::dump_csv({sums_forth, sums_back});
}

Blend two_strata(Blend::Operator op, Stratum top, Stratum bottom, double weight) {
    top.weight = weight;
    bottom.weight = 1.0 - weight;
    return {op, {top, bottom}};
}

const Stratum kBrushed{0.5, {Ndf::ggx, {0.2, 0.8}}, {}, {}, {}};
const Stratum kDull{0.5, {Ndf::beckmann, {0.9, 0.9}}, {}, {}, {}};

Layer layer(double ior, const Roughness& roughness, const Medium& medium = AbsorbingMedium{}) {
    return {{ior, roughness}, medium};
}

TEST(Reciprocity, ReflectedLightGoesBothWaysAlike) {
    const Blend asymmetric = two_strata(Blend::Operator::asymmetric, kBrushed, kDull, 0.4);
    const Blend symmetric = two_strata(Blend::Operator::symmetric, kBrushed, kDull, 0.3);
    const Rgb grey{0.7, 0.7, 0.7};
    const ScatteringMedium haze{{0.1, 0.1, 0.1}, {1.0, 1.0, 1.0}, 0.6, 0.8};
    const std::vector<std::pair<std::string, Material>> materials{
        {"conductor blend",
         {{}, 1.0, {}, ConductorBase{{0.2, 0.2, 0.2}, {3, 3, 3}, asymmetric}, {}}},
        {"diffuse facets", {{}, 1.0, {}, DiffuseFacetsBase{grey, symmetric}, {}}},
        {"coated lambertian",
         {{}, 1.0, {layer(1.5, asymmetric, AbsorbingMedium{grey})}, LambertianBase{grey}, {}}},
        {"coated conductor",
         {{},
          1.0,
          {layer(1.4, Microsurface{Ndf::ggx, {0.3, 0.3}}, haze), layer(1.8, symmetric)},
          ConductorBase{{0.2, 0.2, 0.2}, {3, 3, 3}, Microsurface{Ndf::ggx, {0.4, 0.4}}},
          {}}},
    };
    std::uint64_t seed = 1;
    for (const auto& [name, material] : materials) {
        const TransferTally sum = transfer(material, false, seed++);
        expect_equal(sum.reflected, sum.reflected, 1.0, name);
    }
}

TEST(Reciprocity, TransmittedLightDiffersByTheSquaredIndexRatio) {
    const Blend asymmetric = two_strata(Blend::Operator::asymmetric, kBrushed, kDull, 0.4);
    const ScatteringMedium haze{{0.1, 0.1, 0.1}, {1.0, 1.0, 1.0}, -0.5, 0.8};
    const std::vector<std::tuple<std::string, double, Material>> materials{
        {"interface",
         1.6,
         {{}, 1.0, {layer(1.6, Microsurface{Ndf::ggx, {0.6, 0.6}})}, NoBase{}, {}}},
        {"blend", 0.7, {{}, 1.0, {layer(0.7, asymmetric)}, NoBase{}, {}}},
        {"stack",
         1.25,
         {{},
          1.2,
          {layer(1.5, asymmetric, haze), layer(1.5, Microsurface{Ndf::ggx, {0.0, 0.0}})},
          NoBase{},
          {}}},
    };
    std::uint64_t seed = 11;
    for (const auto& [name, eta, material] : materials) {
        const TransferTally down = transfer(material, false, seed++);
        const TransferTally up = transfer(material, true, seed++);
        expect_equal(down.crossed, up.crossed, eta * eta, name);
        expect_equal(up.reflected, up.reflected, 1.0, name + " from below");
    }
}

struct ScalarTally {
    Moments value;
    std::uint64_t count = 0;

    void merge(const ScalarTally& other) { value.merge(other.value); }
};

struct Value {
    double mean, error;
};

Value density_over_cosine(const SurfaceWalk& surface, const Vec3& to, const Vec3& from,
                          std::uint64_t seed) {
    constexpr std::uint64_t kEstimates = 40'000;
    const auto tally =
        run_walks<ScalarTally>({kEstimates, seed, {}}, [&](RandomStream& random, ScalarTally& sum) {
            sum.value.add(next_event_density(surface, to, from, random).x / std::abs(to.z));
        });
    return {tally.value.mean(kEstimates), tally.value.standard_error(kEstimates)};
}

void expect_same(const Value& one, const Value& other, double scale) {
    const double z = (one.mean - scale * other.mean) / std::hypot(one.error, scale * other.error);
    EXPECT_LT(std::abs(z), test::two_sided_z(test::sidak_significance(kSuiteSignificance, kTests)))
        << one.mean << " against " << scale * other.mean;
}

TEST(Reciprocity, NextEventEstimatesAreReciprocal) {
    const Facets brushed{Ndf::ggx, 0.2, 0.8};
    const Facets dull{Ndf::beckmann, 0.9, 0.9};
    constexpr double kEta = 1.5;
    const FacetMaterial materials[] = {ConductorFacet{{0.2, 0.2, 0.2}, {3, 3, 3}},
                                       DiffuseFacet{{0.8, 0.8, 0.8}}, DielectricFacet{kEta}};
    const Vec3 left = glm::normalize(Vec3{-0.8, 0.3, 0.5});
    const Vec3 right = glm::normalize(Vec3{0.3, 0.2, 0.9});
    const Vec3 below = glm::normalize(Vec3{0.4, -0.2, -0.7});
    for (const auto op : {Blend::Operator::asymmetric, Blend::Operator::symmetric})
        for (const FacetMaterial& material : materials) {
            const SurfaceWalk surface{
                Surface{op, {{0.4, brushed, material}, {0.6, dull, material}}}};
            expect_same(density_over_cosine(surface, left, right, 1),
                        density_over_cosine(surface, right, left, 2), 1.0);
            if (std::holds_alternative<DielectricFacet>(material))
                expect_same(density_over_cosine(surface, below, left, 3),
                            density_over_cosine(surface, left, below, 4), kEta * kEta);
        }
}

}  // namespace
}  // namespace lacquer::simulator
