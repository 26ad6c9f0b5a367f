// Stacks compiled for real time: one lobe for a conductor and the interfaces below the top one
// (LQ_STACK_LOBES 2), and no more layers than there are (LQ_MAX_LAYERS). Against the reference's,
// on random stacks.
#define LQ_STACK_LOBES 2
#define LQ_MAX_LAYERS 4
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stack_models.h"

namespace lacquer::test {
namespace {

using reference::ConductorLobe;

template <typename Model>
class ShaderSharedLobe : public RandomStackTest<Model> {};

TYPED_TEST_SUITE(ShaderSharedLobe, StackModels);

TYPED_TEST(ShaderSharedLobe, AgreesWithTheReference) {
    std::vector<double> errors;
    for (int n = 0; n < 200; ++n) {
        const Material material = this->random_.next();
        const auto truth =
            reference::prepare_stack(material, tables(), TypeParam::kLobes, ConductorLobe::shared);
        const auto surface = this->prepared(material);
        const glm::dvec3 wo = this->random_.direction(0.02);
        for (int light = 0; light < 8; ++light) {
            const glm::dvec3 u = this->random_.numbers();
            const reference::Sample expected = reference::sample(truth, wo, u);
            const shader::LqSample chosen =
                TypeParam::sample(surface, shader::vec3{wo}, shader::vec3{u});
            EXPECT_LE(glm::length(glm::dvec3{chosen.wi} - expected.wi), kDirection)
                << "stack " << n << ", light " << light;
            const glm::dvec3 wi = light % 2 == 0 ? this->random_.direction(0.02) : expected.wi;
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

// As much as from three lobes; all of a conductor's lobe is said to come from the base.
TYPED_TEST(ShaderSharedLobe, HasTheLightOfBoth) {
    int conductors_below_interfaces = 0;
    for (int n = 0; n < 200; ++n) {
        const Material material = this->random_.next();
        const auto apart = reference::prepare_stack(material, tables(), TypeParam::kLobes);
        const auto surface = this->prepared(material);
        const glm::dvec3 wo = this->random_.direction(0.02);
        const reference::Albedo expected = reference::albedo(apart, wo);
        const shader::LqAlbedo albedo = TypeParam::albedo(surface, shader::vec3{wo});
        const bool conducts = std::holds_alternative<ConductorBase>(material.base);
        conductors_below_interfaces += conducts && material.layers.size() > 1 ? 1 : 0;
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(albedo.direct[c] + albedo.base[c], expected.direct[c] + expected.base[c],
                        TypeParam::kEnergy)
                << "stack " << n;
            EXPECT_NEAR(albedo.transmitted[c], expected.transmitted[c], TypeParam::kEnergy)
                << "stack " << n;
            if (conducts)
                EXPECT_GE(albedo.base[c], expected.base[c] - TypeParam::kEnergy) << "stack " << n;
            else
                EXPECT_NEAR(albedo.base[c], expected.base[c], TypeParam::kEnergy) << "stack " << n;
        }
    }
    EXPECT_GT(conductors_below_interfaces, 10);
}

// Under a single clear coat, and without a conductor, there is nothing to share.
TYPED_TEST(ShaderSharedLobe, IsThatOfOneClassWhereTheOtherHasNoLight) {
    int alike = 0;
    for (int n = 0; n < 200; ++n) {
        Material material = this->random_.next();
        if (std::holds_alternative<ConductorBase>(material.base)) {
            material.layers.resize(1);
            material.layers[0].medium = AbsorbingMedium{{0.5, 0.7, 0.9}};
        }
        const auto apart = reference::prepare_stack(material, tables(), TypeParam::kLobes);
        const auto surface = this->prepared(material);
        const glm::dvec3 wo = this->random_.direction(0.02);
        const glm::dvec3 wi = reference::sample(apart, wo, this->random_.numbers()).wi;
        if (std::abs(wi.z) < 0.01) continue;
        const glm::dvec3 f = reference::eval(apart, wi, wo);
        const shader::vec3 value = TypeParam::eval(surface, shader::vec3{wi}, shader::vec3{wo});
        for (int c = 0; c < 3; ++c)
            EXPECT_LE(relative_error(value[c], f[c]), kRelative) << "stack " << n;
        EXPECT_LE(relative_error(TypeParam::pdf(surface, shader::vec3{wi}, shader::vec3{wo}),
                                 reference::pdf(apart, wi, wo)),
                  kRelative)
            << "stack " << n;
        ++alike;
    }
    EXPECT_GT(alike, 100);
}

using ForwardSharedLobe = ShaderSharedLobe<Forward>;

TEST_F(ForwardSharedLobe, IsNoWiderThanTheWiderAndNoNarrowerThanTheNarrower) {
    int between = 0;
    for (int n = 0; n < 200; ++n) {
        const Material material = random_.next();
        const glm::dvec3 wo = random_.direction(0.02);
        const auto apart = reference::prepare_stack(material, tables());
        const reference::StackView seen = reference::view(apart, wo);
        if (seen.lobes.size() < 2) continue;
        const auto [narrow, wide] = std::minmax(seen.lobes.front().alpha, seen.lobes.back().alpha);
        const double alpha =
            shader::lq_stack_view(prepared(material), shader::vec3{wo}).interfaces.alpha;
        EXPECT_GE(alpha, narrow * (1.0 - kRelative)) << "stack " << n;
        EXPECT_LE(alpha, wide * (1.0 + kRelative)) << "stack " << n;
        ++between;
    }
    EXPECT_GT(between, 10);
}

TYPED_TEST(ShaderSharedLobe, WeighsAsSampled) {
    for (int n = 0; n < 50; ++n) {
        const Material material = this->random_.next();
        const auto surface = this->prepared(material);
        const shader::vec3 wo{this->random_.direction(0.05)};
        for (int number = 0; number < 8; ++number) {
            const shader::LqSample chosen =
                TypeParam::sample(surface, wo, shader::vec3{this->random_.numbers()});
            if (chosen.pdf <= 0.0) continue;
            const shader::vec3 f = TypeParam::eval(surface, chosen.wi, wo);
            for (int c = 0; c < 3; ++c)
                EXPECT_LE(
                    relative_error(chosen.weight[c] * chosen.pdf, f[c] * std::abs(chosen.wi.z)),
                    TypeParam::kTypical);
            EXPECT_LE(relative_error(chosen.pdf, TypeParam::pdf(surface, chosen.wi, wo)),
                      TypeParam::kTypical);
        }
    }
}

}  // namespace
}  // namespace lacquer::test
