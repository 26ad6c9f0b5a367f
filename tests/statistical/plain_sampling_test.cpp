// Bsdf::sample against Bsdf::pdf: chi-square over the outgoing hemisphere, 10^6 samples a case.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "lacquer/bsdf.h"
#include "support/chi_square.h"
#include "support/sampling_fit.h"

namespace lacquer {
namespace {

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

TEST(PlainSampling, FollowsItsDensity) {
    const std::vector<SamplingCase> all = cases();
    const double significance =
        test::sidak_significance(kSuiteSignificance, static_cast<int>(all.size()));
    for (const SamplingCase& test_case : all) {
        const glm::dvec3 wo{std::sin(test_case.theta_o), 0.0, std::cos(test_case.theta_o)};
        const Bsdf<float> sampled = prepare<float>(test_case.material);
        const Bsdf<double> bsdf = prepare<double>(test_case.material);
        test::expect_sampling_fit(
            [&](const glm::dvec3& u) -> std::optional<glm::dvec3> {
                const BsdfSample<float> chosen = sampled.sample(glm::vec3{wo}, glm::vec3{u});
                if (!(chosen.pdf > 0.0f)) return std::nullopt;
                return glm::dvec3{chosen.wi};
            },
            [&](const glm::dvec3& wi) { return bsdf.pdf(wi, wo); }, significance,
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
