// Bsdf::sample against Bsdf::pdf: chi-square over the outgoing hemisphere, 10^6 samples a case.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "lacquer/bsdf.h"
#include "support/chi_square.h"
#include "support/expect_fit.h"

namespace lacquer {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSuiteSignificance = 0.01;

struct SamplingCase {
    const char* name;
    Material material;
    double theta_o;
};

Material coated(double alpha, Ndf ndf, Base base) {
    Material material;
    material.layers.push_back({{1.5, Microsurface{ndf, {alpha, alpha}}}, {}});
    material.base = std::move(base);
    return material;
}

Material bare(Base base) {
    Material material;
    material.base = std::move(base);
    return material;
}

ConductorBase gold(Ndf ndf, double alpha_x, double alpha_y) {
    return {{0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}, Microsurface{ndf, {alpha_x, alpha_y}}};
}

std::vector<SamplingCase> cases() {
    const LambertianBase white{{0.8, 0.8, 0.8}};
    const LambertianBase red{{0.6, 0.05, 0.05}};
    std::vector<SamplingCase> all;
    for (const double theta : {0.0, 0.7, 1.3}) {
        all.push_back({"glaze", coated(0.15, Ndf::ggx, white), theta});
        all.push_back({"rough_plastic", coated(0.5, Ndf::beckmann, red), theta});
        all.push_back({"gold", bare(gold(Ndf::ggx, 0.2, 0.2)), theta});
        all.push_back({"brushed_gold", bare(gold(Ndf::ggx, 0.15, 0.6)), theta});
        all.push_back({"beckmann_gold", bare(gold(Ndf::beckmann, 0.3, 0.3)), theta});
        all.push_back({"coated_gold", coated(0.3, Ndf::ggx, gold(Ndf::ggx, 0.4, 0.4)), theta});
        all.push_back({"glass", coated(0.25, Ndf::ggx, NoBase{}), theta});
    }
    return all;
}

// Cells of equal solid angle over the upper hemisphere, and one for samples without a direction.
constexpr int kRows = 32;
constexpr int kColumns = 64;
constexpr int kCells = kRows * kColumns + 1;
constexpr int kSub = 12;  // midpoints per cell side for the expectation
constexpr int kSamples = 1'000'000;

std::vector<double> count_samples(const Bsdf<float>& bsdf, const glm::vec3& wo) {
    std::mt19937 generator(20231);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto next = [&] { return std::min(uniform(generator), 0x1.fffffep-1f); };
    std::vector<double> counts(kCells, 0.0);
    for (int i = 0; i < kSamples; ++i) {
        const glm::vec3 u{next(), next(), next()};
        const BsdfSample<float> chosen = bsdf.sample(wo, u);
        if (!(chosen.pdf > 0.0f)) {
            counts.back() += 1.0;
            continue;
        }
        const double turn = std::atan2(chosen.wi.y, chosen.wi.x) / (2 * kPi);
        const int row = std::min(static_cast<int>(chosen.wi.z * kRows), kRows - 1);
        const int column =
            std::min(static_cast<int>((turn - std::floor(turn)) * kColumns), kColumns - 1);
        counts[static_cast<std::size_t>(row * kColumns + column)] += 1.0;
    }
    return counts;
}

std::vector<double> expect_samples(const Bsdf<double>& bsdf, const glm::dvec3& wo) {
    std::vector<double> expected(kCells, 0.0);
    const double area = 2 * kPi / (kRows * kSub) / (kColumns * kSub);
    double total = 0.0;
    for (int i = 0; i < kRows * kSub; ++i)
        for (int j = 0; j < kColumns * kSub; ++j) {
            const double z = (i + 0.5) / (kRows * kSub);
            const double phi = 2 * kPi * (j + 0.5) / (kColumns * kSub);
            const double radius = std::sqrt(1 - z * z);
            const double share =
                area * bsdf.pdf({radius * std::cos(phi), radius * std::sin(phi), z}, wo);
            expected[static_cast<std::size_t>(i / kSub * kColumns + j / kSub)] += kSamples * share;
            total += share;
        }
    expected.back() = kSamples * std::max(0.0, 1.0 - total);
    return expected;
}

TEST(PlainSampling, FollowsItsDensity) {
    const std::vector<SamplingCase> all = cases();
    const double significance =
        test::sidak_significance(kSuiteSignificance, static_cast<int>(all.size()));
    for (const SamplingCase& test_case : all) {
        const glm::dvec3 wo{std::sin(test_case.theta_o), 0.0, std::cos(test_case.theta_o)};
        const auto observed = count_samples(prepare<float>(test_case.material), glm::vec3{wo});
        const auto expected = expect_samples(prepare<double>(test_case.material), wo);
        test::expect_fit(observed, expected, significance,
                         test_case.name + (" at " + std::to_string(test_case.theta_o)));
    }
}

TEST(PlainSampling, WeightsAverageToTheAlbedo) {
    constexpr int kCount = 200'000;
    constexpr int kPoints = 16'384;
    constexpr double kPointError = 5e-4;  // of that many low-discrepancy points, by doubling them
    for (const SamplingCase& test_case : cases()) {
        const glm::dvec3 wo{std::sin(test_case.theta_o), 0.0, std::cos(test_case.theta_o)};
        const Bsdf<double> bsdf = prepare<double>(test_case.material);
        std::mt19937 generator(7);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        double sum = 0.0;
        double squares = 0.0;
        for (int i = 0; i < kCount; ++i) {
            const glm::dvec3 u{uniform(generator), uniform(generator), uniform(generator)};
            const double weight = bsdf.sample(wo, u).weight.x;
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / kCount;
        const double standard_error =
            std::sqrt(std::max(0.0, squares / kCount - mean * mean) / kCount);
        const DirectionalAlbedo<double> albedo = bsdf.albedo(wo, kPoints);
        EXPECT_NEAR(mean, albedo.direct.x + albedo.base.x, 4 * standard_error + kPointError)
            << test_case.name << " at " << test_case.theta_o;
    }
}

}  // namespace
}  // namespace lacquer
