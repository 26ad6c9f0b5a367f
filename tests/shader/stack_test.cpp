// lq_stack_* and lq_stack_symmetric_* against the reference's stacks, on random ones: in double the
// same formulas, in float the same but for rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stack_models.h"

namespace lacquer::test {
namespace {

template <typename Model>
class ShaderStack : public RandomStackTest<Model> {};

template <typename Model>
class ShaderBlendedStack : public RandomBlendTest<Model> {};

TYPED_TEST_SUITE(ShaderStack, StackModels);
TYPED_TEST_SUITE(ShaderBlendedStack, StackModels);

// Relative errors of f and pdf, in their order; albedos are expected to be as good as `energy`.
template <typename Model>
std::vector<double> sorted_errors(RandomStackTest<Model>& stacks, int count, double energy) {
    std::vector<double> errors;
    for (int n = 0; n < count; ++n) {
        const Material material = stacks.random_.next();
        const auto truth = reference::prepare_stack(material, tables(), Model::kLobes);
        const auto surface = stacks.prepared(material);
        const glm::dvec3 wo = stacks.random_.direction(0.02);
        const reference::Albedo expected = reference::albedo(truth, wo);
        const shader::LqAlbedo albedo = Model::albedo(surface, shader::vec3{wo});
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(albedo.direct[c], expected.direct[c], energy) << "stack " << n;
            EXPECT_NEAR(albedo.base[c], expected.base[c], energy) << "stack " << n;
            EXPECT_NEAR(albedo.transmitted[c], expected.transmitted[c], energy) << "stack " << n;
        }
        for (int light = 0; light < 16; ++light) {
            const glm::dvec3 u = stacks.random_.numbers();
            const glm::dvec3 wi = light % 2 == 0 ? stacks.random_.direction(0.02)
                                                 : reference::sample(truth, wo, u).wi;
            if (std::abs(wi.z) < 0.01) continue;
            const glm::dvec3 f = reference::eval(truth, wi, wo);
            const shader::vec3 value = Model::eval(surface, shader::vec3{wi}, shader::vec3{wo});
            for (int c = 0; c < 3; ++c) errors.push_back(relative_error(value[c], f[c]));
            errors.push_back(relative_error(Model::pdf(surface, shader::vec3{wi}, shader::vec3{wo}),
                                            reference::pdf(truth, wi, wo)));
        }
    }
    std::ranges::sort(errors);
    testing::Test::RecordProperty("median", std::to_string(errors[errors.size() / 2]));
    testing::Test::RecordProperty("largest", std::to_string(errors.back()));
    return errors;
}

TYPED_TEST(ShaderStack, AgreesWithTheReference) {
    const auto errors = sorted_errors<TypeParam>(*this, 300, TypeParam::kEnergy);
    EXPECT_LE(errors[errors.size() / 2], TypeParam::kTypical);
    EXPECT_LE(errors.back(), kRelative);
}

// Logarithms of shares are good to 5e-7 (microsurface/strata.glsl), which all but those above 35
// times their 1 + Lambda keep of the light that passes a stratum.
TYPED_TEST(ShaderBlendedStack, AgreesWithTheReference) {
#ifdef LACQUER_TEST_FLOAT
    constexpr double kTypicalBlend = 2e-6, kEnergyBlend = 1e-5;
#else
    constexpr double kTypicalBlend = 5e-7, kEnergyBlend = 5e-6;
#endif
    constexpr double kRelativeBlend = 35.0 * 5e-7 + kRelative;
    const auto errors = sorted_errors<TypeParam>(*this, 200, kEnergyBlend);
    EXPECT_LE(errors[errors.size() / 2], kTypicalBlend);
    EXPECT_LE(errors.back(), kRelativeBlend);
}

// That numbers choose the same directions with the same weights.
TYPED_TEST(ShaderStack, SamplesLikeTheReference) {
    for (int n = 0; n < 100; ++n) {
        const Material material = this->random_.next();
        const auto truth = reference::prepare_stack(material, tables(), TypeParam::kLobes);
        const auto surface = this->prepared(material);
        const glm::dvec3 wo = this->random_.direction(0.05);
        for (int number = 0; number < 16; ++number) {
            const glm::dvec3 u = this->random_.numbers();
            const reference::Sample expected = reference::sample(truth, wo, u);
            const shader::LqSample chosen =
                TypeParam::sample(surface, shader::vec3{wo}, shader::vec3{u});
            EXPECT_LE(glm::length(glm::dvec3{chosen.wi} - expected.wi), kDirection)
                << "stack " << n << ", number " << number;
        }
    }
}

// That f is the same when light and viewer change places, but for a few roundings.
using ShaderStackSymmetric = RandomStackTest<Symmetric>;

TEST_F(ShaderStackSymmetric, IsReciprocal) {
#ifdef LACQUER_TEST_FLOAT
    constexpr double kSymmetric = 1e-6;
#else
    constexpr double kSymmetric = 1e-13;
#endif
    for (int n = 0; n < 100; ++n) {
        const auto surface = prepared(random_.next());
        for (int pair = 0; pair < 16; ++pair) {
            const shader::vec3 a{random_.direction(0.02)}, b{random_.direction(0.02)};
            const shader::vec3 there = Symmetric::eval(surface, a, b);
            const shader::vec3 back = Symmetric::eval(surface, b, a);
            for (int c = 0; c < 3; ++c)
                EXPECT_LE(relative_error(there[c], back[c]), kSymmetric) << "stack " << n;
        }
    }
}

}  // namespace
}  // namespace lacquer::test
