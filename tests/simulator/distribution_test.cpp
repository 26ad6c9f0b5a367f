// Stacks against exact results: smooth layers by adding, the diffuse lobe under rough coats by
// reciprocity, and the simulator's ways of measuring one thing against each other.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "simulator/albedo.h"
#include "simulator/goniophotometer.h"
#include "simulator/interface.h"
#include "simulator/slice.h"
#include "support/chi_square.h"
#include "support/normal.h"

namespace lacquer::simulator {
namespace {

constexpr double kSuiteSignificance = 0.01;
constexpr double kRounding = 1e-12;

void expect_within(double mine, double expected, double error, int comparisons,
                   const std::string& what) {
    const double limit =
        test::two_sided_z(test::sidak_significance(kSuiteSignificance, comparisons));
    EXPECT_LT(std::abs(mine - expected), limit * error + kRounding)
        << what << ": " << mine << " against " << expected << ", standard error " << error;
}

struct SmoothLayer {
    double ior, tau;
};

struct Reflectances {
    double reflected, transmitted;
};

// Adds the layers from the last one up (Stokes): light of one refracted direction has one cosine in
// each medium.
Reflectances add_layers(const std::vector<SmoothLayer>& layers, double exterior_ior, double cosine,
                        double base_reflectance) {
    std::vector<double> iors{exterior_ior};
    for (const SmoothLayer& layer : layers) iors.push_back(layer.ior);
    std::vector<double> cosines;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    for (const double ior : iors)
        cosines.push_back(std::sqrt(1.0 - std::pow(sine * exterior_ior / ior, 2)));
    Reflectances below{base_reflectance, 1.0 - base_reflectance};
    for (std::size_t index = layers.size(); index-- > 0;) {
        const double r = dielectric_reflectance(cosines[index], iors[index + 1] / iors[index]);
        const double tau = std::pow(layers[index].tau, 1.0 / cosines[index + 1]);
        const double returned = tau * tau * below.reflected;
        const double series = 1.0 - r * returned;
        below = {r + (1 - r) * (1 - r) * returned / series,
                 (1 - r) * tau * below.transmitted / series};
    }
    return below;
}

TEST(SmoothLayers, MatchTheExactAddingResult) {
    const std::vector<SmoothLayer> layers{{1.5, 0.8}, {1.9, 0.6}, {1.3, 1.0}, {1.7, 0.9}};
    constexpr double kExterior = 1.1;
    const ConductorBase gold{{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}, Microsurface{}};
    Material material;
    material.exterior_ior = kExterior;
    for (const SmoothLayer& layer : layers)
        material.layers.push_back(
            {{layer.ior, Microsurface{}}, AbsorbingMedium{{layer.tau, layer.tau, layer.tau}}});
    constexpr int kComparisons = 2 * (2 + 3);
    for (const double cosine : {1.0, 0.5}) {
        material.base = NoBase{};
        const AlbedoEstimate open = estimate_albedo(StackWalk{material}, cosine, {300'000, 1, {}});
        const Reflectances known = add_layers(layers, kExterior, cosine, 0.0);
        expect_within(open.total.mean[0], known.reflected, open.total.standard_error[0],
                      kComparisons, "reflected");
        expect_within(open.transmitted.mean[0], known.transmitted,
                      open.transmitted.standard_error[0], kComparisons, "transmitted");
        material.base = gold;
        const AlbedoEstimate coated =
            estimate_albedo(StackWalk{material}, cosine, {300'000, 2, {}});
        const double sine = std::sqrt(1.0 - cosine * cosine) * kExterior / layers.back().ior;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double metal = conductor_reflectance(std::sqrt(1.0 - sine * sine),
                                                       gold.eta[channel] / layers.back().ior,
                                                       gold.kappa[channel] / layers.back().ior);
            expect_within(coated.total.mean[channel],
                          add_layers(layers, kExterior, cosine, metal).reflected,
                          coated.total.standard_error[channel], kComparisons, "over gold");
        }
    }
}

// Share of the light that arrives within each row of the hemisphere, in proportion to the cosine,
// and gets through an interface and the medium below.
struct RowTally {
    std::vector<Moments> rows;
    std::uint64_t count = 0;

    void merge(const RowTally& other) {
        if (rows.empty()) rows.resize(other.rows.size());
        for (std::size_t row = 0; row < other.rows.size(); ++row) rows[row].merge(other.rows[row]);
    }
};

TEST(DiffuseLobe, UnderARoughCoatItIsTheProductOfTwoTransmittances) {
    // A Lambertian base forgets where light came from, and all else is reciprocal, so that
    // f_base(wi, wo) = T(wi) T(wo) rho / (pi eta^2 (1 - rho R_bar)).
    struct Case {
        double eta, alpha, tau;
    };
    constexpr Case kCases[] = {{0.8, 0.1, 0.7}, {1.5, 0.5, 0.7}, {1.5, 0.1, 1.0}};
    constexpr int kRows = 16;
    constexpr int kComparisons = 3 * kRows;
    constexpr double kAlbedo = 0.8;
    constexpr double kCosine = 0.6;
    constexpr std::uint64_t kWalks = 400'000;
    for (const auto& [eta, alpha, tau] : kCases) {
        const Facets facets{Ndf::ggx, alpha, alpha};
        Material material;
        material.layers = {
            {{eta, Microsurface{Ndf::ggx, {alpha, alpha}}}, AbsorbingMedium{{tau, tau, tau}}}};
        material.base = NoBase{};
        const StackWalk coat{material};
        const HemisphereGrid grid{kRows, 1};
        const auto entering =
            run_walks<RowTally>({kWalks, 1, {}}, [&](RandomStream& random, RowTally& sum) {
                if (sum.rows.empty()) sum.rows.resize(kRows);
                const Vec3 wi = sample_cosine(random);
                const Exit exit = coat.walk(wi, random);
                sum.rows[grid.cell(wi)].add(exit.fate == Fate::transmitted ? exit.weight.x : 0.0);
            });
        const InterfaceEstimate coefficients =
            estimate_interface(facets, eta, tau, kCosine, {kWalks, 2, {}});
        const double shared = coefficients.t_down.mean * kAlbedo /
                              (eta * eta * (1.0 - kAlbedo * coefficients.r_up.mean));
        const double shared_error = std::hypot(
            coefficients.t_down.standard_error / coefficients.t_down.mean,
            kAlbedo * coefficients.r_up.standard_error / (1.0 - kAlbedo * coefficients.r_up.mean));
        material.base = LambertianBase{{kAlbedo, kAlbedo, kAlbedo}};
        const Vec3 wo{std::sqrt(1.0 - kCosine * kCosine), 0.0, kCosine};
        const auto measured = estimate_distribution(StackWalk{material}, wo, grid, {kWalks, 3, {}});
        for (std::size_t row = 0; row < kRows; ++row) {
            const Moments& got_in = entering.rows[row];
            const double expected = shared * got_in.mean(kWalks);
            const double error =
                std::hypot(shared * got_in.standard_error(kWalks), expected * shared_error,
                           measured.base.rows[row].standard_error[0]);
            expect_within(measured.base.rows[row].mean[0], expected, error, kComparisons,
                          "row " + std::to_string(row) + " eta " + std::to_string(eta));
        }
    }
}

TEST(Goniophotometer, LambertianSurfaceHasItsMeanAndVariance) {
    Material material;
    material.base = LambertianBase{{0.2, 0.5, 1.0}};
    const auto result = estimate_distribution(StackWalk{material}, glm::normalize(Vec3{1, 2, 1}),
                                              {8, 8}, {100'000, 1, {}});
    constexpr int kComparisons = 3 * (2 + 2);
    for (std::size_t channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(result.base.energy.mean[channel],
                    std::get<LambertianBase>(material.base).albedo[channel], 1e-12);
        for (const auto* mean : {&result.base.mean_x, &result.base.mean_y})
            expect_within(mean->mean[channel], 0.0, mean->standard_error[channel], kComparisons,
                          "mean");
        for (const auto* variance : {&result.base.variance_x, &result.base.variance_y})
            expect_within(variance->mean[channel], 0.25, variance->standard_error[channel],
                          kComparisons, "variance");
    }
    EXPECT_EQ(result.direct.energy.mean[0], 0.0);
    EXPECT_EQ(result.transmitted.cells.size(), 64u);
}

TEST(Goniophotometer, CellsAndRowsAddUpToTheEnergy) {
    Material material;
    material.layers = {
        {{1.5, Microsurface{Ndf::ggx, {0.3, 0.6}}}, AbsorbingMedium{{0.5, 0.7, 1.0}}}};
    material.base = NoBase{};
    const auto result = estimate_distribution(StackWalk{material}, glm::normalize(Vec3{1, 0, 1}),
                                              {32, 64}, {50'000, 1, {}});
    for (const Distribution* distribution : {&result.direct, &result.transmitted}) {
        double cells = 0.0;
        double rows = 0.0;
        for (const RgbEstimate& cell : distribution->cells) cells += cell.mean[1];
        for (const RgbEstimate& row : distribution->rows) rows += row.mean[1];
        EXPECT_NEAR(cells, distribution->energy.mean[1], kRounding);
        EXPECT_NEAR(rows, distribution->energy.mean[1], kRounding);
    }
    // Light that arrives along +x is reflected and refracted towards -x.
    EXPECT_LT(result.direct.mean_x.mean[1], 0.0);
    EXPECT_LT(result.transmitted.mean_x.mean[1], 0.0);
}

TEST(Slice, NextEventAndHistogramAgree) {
    // One rough surface by next-event estimates, and the same over a black base, which is no single
    // surface to the simulator, by histogram. Pixels are small beside the lobe.
    Material material;
    material.layers = {{{1.5, Microsurface{Ndf::ggx, {0.6, 0.6}}}, AbsorbingMedium{}}};
    material.base = NoBase{};
    const Vec3 wo = glm::normalize(Vec3{0.5, 0.0, 1.0});
    constexpr int kSize = 16;
    const SliceEstimate direct = estimate_slice(StackWalk{material}, wo, kSize, {400'000, 1, {}});
    ASSERT_EQ(direct.method, SliceMethod::next_event);
    material.base = LambertianBase{{0.0, 0.0, 0.0}};
    const SliceEstimate histogram =
        estimate_slice(StackWalk{material}, wo, kSize, {1'000'000, 2, {}});
    ASSERT_EQ(histogram.method, SliceMethod::histogram);
    int compared = 0;
    for (int row = 4; row < 12; ++row)
        for (int column = 4; column < 12; ++column) {
            const auto index = static_cast<std::size_t>(row * kSize + column);
            const RgbEstimate& a = direct.pixels[index];
            const RgbEstimate& b = histogram.pixels[index];
            // The value at the centre differs from the mean by the curvature over the pixel:
            // below a hundredth for this lobe and size.
            const double error = std::hypot(a.standard_error[0], b.standard_error[0]);
            EXPECT_NEAR(a.mean[0], b.mean[0], 4.0 * error + 0.01 * b.mean[0])
                << row << " " << column;
            ++compared;
        }
    EXPECT_EQ(compared, 64);
}

}  // namespace
}  // namespace lacquer::simulator
