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

TYPED_TEST_SUITE(ShaderStack, StackModels);

TYPED_TEST(ShaderStack, AgreesWithTheReference) {
    std::vector<double> errors;
    for (int n = 0; n < 300; ++n) {
        const Material material = this->random_.next();
        const auto truth = reference::prepare_stack(material, tables(), TypeParam::kLobes);
        const auto surface = this->prepared(material);
        const glm::dvec3 wo = this->random_.direction(0.02);
        const reference::Albedo expected = reference::albedo(truth, wo);
        const shader::LqAlbedo albedo = TypeParam::albedo(surface, shader::vec3{wo});
        for (int c = 0; c < 3; ++c) {
            constexpr double kEnergy = TypeParam::kEnergy;
            EXPECT_NEAR(albedo.direct[c], expected.direct[c], kEnergy) << "stack " << n;
            EXPECT_NEAR(albedo.base[c], expected.base[c], kEnergy) << "stack " << n;
            EXPECT_NEAR(albedo.transmitted[c], expected.transmitted[c], kEnergy) << "stack " << n;
        }
        for (int light = 0; light < 16; ++light) {
            const glm::dvec3 u = this->random_.numbers();
            const glm::dvec3 wi =
                light % 2 == 0 ? this->random_.direction(0.02) : reference::sample(truth, wo, u).wi;
            if (std::abs(wi.z) < 0.01) continue;
            const glm::dvec3 f = reference::eval(truth, wi, wo);
            const shader::vec3 value = TypeParam::eval(surface, shader::vec3{wi}, shader::vec3{wo});
            for (int c = 0; c < 3; ++c) errors.push_back(relative_error(value[c], f[c]));
            errors.push_back(
                relative_error(TypeParam::pdf(surface, shader::vec3{wi}, shader::vec3{wo}),
                               reference::pdf(truth, wi, wo)));
        }
    }
    std::ranges::sort(errors);
    EXPECT_LE(errors[errors.size() / 2], TypeParam::kTypical);
    EXPECT_LE(errors.back(), kRelative);
    this->RecordProperty("median", std::to_string(errors[errors.size() / 2]));
    this->RecordProperty("largest", std::to_string(errors.back()));
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
