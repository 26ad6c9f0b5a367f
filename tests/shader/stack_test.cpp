// lq_stack_* against the reference's stack, on random stacks: in double the same formulas, in float
// the same but for rounding.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "reference/stack/stack.h"
#include "shader.h"

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

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

class RandomStacks {
 public:
    double uniform(double low, double high) {
        return std::uniform_real_distribution<double>{low, high}(random_);
    }

    // One to four layers, a third of whose media scatter, over any base.
    Material next() {
        Material material;
        const int count = 1 + static_cast<int>(uniform(0.0, 4.0));
        for (int n = 0; n < count; ++n) {
            Layer layer{{uniform(0.8, 2.2), facets()}, AbsorbingMedium{rgb(0.3, 1.0)}};
            if (uniform(0.0, 3.0) < 1.0)
                layer.medium =
                    ScatteringMedium{rgb(0.0, 0.5), rgb(0.0, 3.0), uniform(-0.5, 0.95), 1.0};
            material.layers.push_back(layer);
        }
        const double base = uniform(0.0, 3.0);
        if (base < 1.0)
            material.base = NoBase{};
        else if (base < 2.0)
            material.base = LambertianBase{rgb(0.0, 1.0)};
        else
            material.base = ConductorBase{rgb(0.1, 3.0), rgb(0.5, 8.0), facets()};
        return material;
    }

    glm::dvec3 direction(double least_cosine) {
        const double cosine = uniform(least_cosine, 1.0), turn = uniform(0.0, 6.28);
        const double sine = std::sqrt(1.0 - cosine * cosine);
        return {sine * std::cos(turn), sine * std::sin(turn), cosine};
    }

 private:
    // Every fourth smooth, every fourth Beckmann's.
    Microsurface facets() {
        const double kind = uniform(0.0, 4.0), alpha = kind < 1.0 ? 0.0 : uniform(0.002, 0.8);
        return {kind > 3.0 ? Ndf::beckmann : Ndf::ggx, {alpha, alpha}};
    }
    Rgb rgb(double low, double high) {
        return {uniform(low, high), uniform(low, high), uniform(low, high)};
    }

    std::mt19937_64 random_{20180812};
};

shader::vec3 to_vec(const Rgb& rgb) {
    return shader::vec3{rgb[0], rgb[1], rgb[2]};
}

shader::LqFacets to_facets(const Microsurface& facets) {
    return {facets.ndf == Ndf::ggx ? shader::LQ_NDF_GGX : shader::LQ_NDF_BECKMANN,
            static_cast<shader::Real>(facets.alpha[0]), static_cast<shader::Real>(facets.alpha[1])};
}

std::vector<shader::vec4> to_rows(const Material& material) {
    std::vector<shader::vec4> rows;
    for (const Layer& layer : material.layers) {
        const auto& facets = std::get<Microsurface>(layer.interface.roughness);
        rows.emplace_back(facets.alpha[0], facets.alpha[1], layer.interface.ior,
                          to_facets(facets).ndf);
        if (const auto* absorbing = std::get_if<AbsorbingMedium>(&layer.medium)) {
            const Rgb& tau = absorbing->tau;
            rows.emplace_back(-std::log(tau[0]), -std::log(tau[1]), -std::log(tau[2]), 0.0);
            rows.emplace_back(0.0);
        } else {
            const auto& slab = std::get<ScatteringMedium>(layer.medium);
            rows.emplace_back(to_vec(slab.sigma_a), slab.g);
            rows.emplace_back(to_vec(slab.sigma_s), 0.0);
        }
    }
    return rows;
}

// Of the rows that shader::stack_rows points to.
shader::LqStackSurface prepare(const Material& material) {
    shader::LqStackMaterial stack{};
    stack.layer_count = static_cast<int>(material.layers.size());
    stack.base = shader::LQ_STACK_BASE_NONE;
    if (const auto* lambertian = std::get_if<LambertianBase>(&material.base)) {
        stack.base = shader::LQ_STACK_BASE_LAMBERTIAN;
        stack.albedo = to_vec(lambertian->albedo);
    } else if (const auto* conductor = std::get_if<ConductorBase>(&material.base)) {
        stack.base = shader::LQ_STACK_BASE_CONDUCTOR;
        stack.facets = to_facets(std::get<Microsurface>(conductor->roughness));
        stack.eta = to_vec(conductor->eta);
        stack.kappa = to_vec(conductor->kappa);
    }
    return shader::lq_stack_prepare(stack);
}

double relative_error(double value, double expected) {
    return std::abs(value - expected) / (std::abs(expected) + 1e-9);
}

TEST(ShaderStack, AgreesWithTheReference) {
    RandomStacks random;
    std::vector<double> errors;
    for (int n = 0; n < 300; ++n) {
        const Material material = random.next();
        const auto truth = reference::prepare_stack(material, tables());
        const std::vector<shader::vec4> rows = to_rows(material);
        shader::stack_rows = rows.data();
        const shader::LqStackSurface surface = prepare(material);
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
        const shader::LqStackSurface surface = prepare(material);
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
