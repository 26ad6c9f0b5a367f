// The sampler of the reference's `coated` against its density: chi-square over the outgoing
// hemisphere.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "reference/coated.h"
#include "support/chi_square.h"
#include "support/sampling_fit.h"

namespace lacquer {
namespace {

using reference::BaseLobe;

constexpr double kSuiteSignificance = 0.01;

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

struct SamplingCase {
    std::string name;
    Material material;
};

Material coated(double eta, Microsurface microsurface, const Rgb& tau, const Rgb& albedo) {
    Material material;
    material.layers.push_back({{eta, microsurface}, AbsorbingMedium{tau}});
    material.base = LambertianBase{albedo};
    return material;
}

std::vector<SamplingCase> cases() {
    return {
        {"glaze", coated(1.5, {Ndf::ggx, {0.15, 0.15}}, {0.7, 0.9, 0.8}, {0.8, 0.8, 0.75})},
        {"matt lacquer", coated(1.4, {Ndf::beckmann, {0.6, 0.6}}, {0.9, 0.1, 0.1}, {1, 1, 1})},
        {"brushed varnish", coated(1.6, {Ndf::ggx, {0.1, 0.5}}, {1, 1, 1}, {0.5, 0.3, 0.2})},
        {"film of air", coated(0.7, {Ndf::ggx, {0.3, 0.3}}, {1, 1, 1}, {0.9, 0.9, 0.9})},
        {"black below", coated(2.5, {Ndf::ggx, {1.0, 1.0}}, {1, 1, 1}, {0, 0, 0})},
        {"no contrast", coated(1.0, {Ndf::ggx, {0.3, 0.3}}, {0.5, 0.5, 0.5}, {1, 1, 1})},
    };
}

TEST(CoatedSampling, FollowsItsDensity) {
    const std::vector<double> angles{0.0, 0.7, 1.4};
    const std::vector<SamplingCase> all = cases();
    const double significance = test::sidak_significance(
        kSuiteSignificance, static_cast<int>(2 * all.size() * angles.size()));
    for (const auto& [name, material] : all)
        for (const BaseLobe shape : {BaseLobe::exact, BaseLobe::ggx}) {
            const auto surface = reference::prepare_coated(material, tables(), shape);
            for (const double theta : angles) {
                const glm::dvec3 wo{std::sin(theta), 0.0, std::cos(theta)};
                test::expect_sampling_fit(
                    [&](const glm::dvec3& u) -> std::optional<glm::dvec3> {
                        const reference::Sample chosen = reference::sample(surface, wo, u);
                        if (!(chosen.pdf > 0.0)) return std::nullopt;
                        return chosen.wi;
                    },
                    [&](const glm::dvec3& wi) { return reference::pdf(surface, wi, wo); },
                    significance,
                    name + (shape == BaseLobe::exact ? ", exact, at " : ", ggx, at ") +
                        std::to_string(theta));
            }
        }
}

}  // namespace
}  // namespace lacquer
