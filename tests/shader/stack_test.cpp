// lq_stack_* against the reference's stack, on random stacks: in double the same formulas, in float
// the same but for rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "random_stacks.h"
#include "reference/stack/stack.h"

namespace lacquer::test {
namespace {

// Of f and pdf. In double thresholds and quotients of small numbers leave this; in float, rounding
// grows along the transport and by the fourth power of a lobe's slope.
#ifdef LACQUER_TEST_FLOAT
constexpr double kRelative = 3e-3;
constexpr double kTypical = 1e-6;  // in the median
constexpr double kEnergy = 2e-6;
#else
constexpr double kRelative = 2e-7;  // Beckmann's masking is a fit to 1e-7; GGX alone needs 1e-9
constexpr double kTypical = 1e-11;
constexpr double kEnergy = 1e-10;
#endif

TEST(ShaderStack, AgreesWithTheReference) {
    RandomStacks random;
    std::vector<double> errors;
    for (int n = 0; n < 300; ++n) {
        const Material material = random.next();
        const auto truth = reference::prepare_stack(material, tables());
        const std::vector<shader::vec4> rows = to_rows(material);
        shader::stack_rows = rows.data();
        const shader::LqStackSurface surface = shader::lq_stack_prepare(to_stack(material));
        const glm::dvec3 wo = random.direction(0.02);
        const reference::Albedo expected = reference::albedo(truth, wo);
        const shader::LqAlbedo albedo = shader::lq_stack_albedo(surface, shader::vec3{wo});
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(albedo.direct[c], expected.direct[c], kEnergy) << "stack " << n;
            EXPECT_NEAR(albedo.base[c], expected.base[c], kEnergy) << "stack " << n;
            EXPECT_NEAR(albedo.transmitted[c], expected.transmitted[c], kEnergy) << "stack " << n;
        }
        for (int light = 0; light < 16; ++light) {
            const glm::dvec3 u{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
            const glm::dvec3 wi =
                light % 2 == 0 ? random.direction(0.02) : reference::sample(truth, wo, u).wi;
            if (std::abs(wi.z) < 0.01) continue;
            const glm::dvec3 f = reference::eval(truth, wi, wo);
            const shader::vec3 value =
                shader::lq_stack_eval(surface, shader::vec3{wi}, shader::vec3{wo});
            for (int c = 0; c < 3; ++c) errors.push_back(relative_error(value[c], f[c]));
            errors.push_back(
                relative_error(shader::lq_stack_pdf(surface, shader::vec3{wi}, shader::vec3{wo}),
                               reference::pdf(truth, wi, wo)));
        }
    }
    std::ranges::sort(errors);
    EXPECT_LE(errors[errors.size() / 2], kTypical);
    EXPECT_LE(errors.back(), kRelative);
    RecordProperty("median", std::to_string(errors[errors.size() / 2]));
    RecordProperty("largest", std::to_string(errors.back()));
}

// That numbers choose the same directions with the same weights.
TEST(ShaderStack, SamplesLikeTheReference) {
#ifdef LACQUER_TEST_FLOAT
    constexpr double kDirection = 1e-3;
#else
    constexpr double kDirection = 2e-7;  // Beckmann's normals come from a fit of the inverse of erf
#endif
    RandomStacks random;
    for (int n = 0; n < 100; ++n) {
        const Material material = random.next();
        const auto truth = reference::prepare_stack(material, tables());
        const std::vector<shader::vec4> rows = to_rows(material);
        shader::stack_rows = rows.data();
        const shader::LqStackSurface surface = shader::lq_stack_prepare(to_stack(material));
        const glm::dvec3 wo = random.direction(0.05);
        for (int number = 0; number < 16; ++number) {
            const glm::dvec3 u{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)};
            const reference::Sample expected = reference::sample(truth, wo, u);
            const shader::LqSample chosen =
                shader::lq_stack_sample(surface, shader::vec3{wo}, shader::vec3{u});
            EXPECT_LE(glm::length(glm::dvec3{chosen.wi} - expected.wi), kDirection)
                << "stack " << n << ", number " << number;
        }
    }
}

}  // namespace
}  // namespace lacquer::test
