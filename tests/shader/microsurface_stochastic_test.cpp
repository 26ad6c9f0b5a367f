// The walks of `lq_microsurface_stochastic_*` against those of the reference: both draw the same
// random numbers, so that they agree query by query and not in the mean only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "reference/microsurface/microsurface_stochastic.h"
#include "shader.h"
#include "shading/microsurface_parameters.h"
#include "support/random_microsurfaces.h"

namespace lacquer::shader_test {
namespace {

vec3 rounded(const Rgb& rgb) {
    return {real(rgb[0]), real(rgb[1]), real(rgb[2])};
}

shader::LqMicrosurfaceSurface prepared(const Material& material) {
    const MicrosurfaceParameters parameters =
        microsurface_parameters(material, Model::microsurface_single);
    const auto stratum = [&](std::size_t k) -> shader::LqStratum {
        if (k >= parameters.strata.size()) return {{0, real(1), real(1)}, real(0), {}, {}};
        const auto& own = parameters.strata[k];
        return {
            {own.microsurface.ndf == Ndf::beckmann ? shader::LQ_NDF_BECKMANN : shader::LQ_NDF_GGX,
             real(own.microsurface.alpha[0]), real(own.microsurface.alpha[1])},
            real(own.weight),
            rounded(own.eta),
            rounded(own.kappa)};
    };
    return shader::lq_microsurface_prepare(
        {parameters.op == Blend::Operator::symmetric ? shader::LQ_BLEND_SYMMETRIC
                                                     : shader::LQ_BLEND_ASYMMETRIC,
         static_cast<int>(parameters.strata.size()), real(parameters.eta),
         rounded(parameters.optical_depth), stratum(0), stratum(1), stratum(2), stratum(3)});
}

constexpr double kSmallValue = 1e-3;

// Relative errors of values of random surfaces, in rising order.
template <typename Error>
std::vector<double> errors_over_surfaces(int surfaces, int per_surface, const Error& error) {
    std::mt19937_64 generator{20230905};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    std::vector<double> errors;
    for (int n = 0; n < surfaces; ++n) {
        const int strata = 1 + n / 2 % 4;
        const bool refracts = n % 2 == 1;
        const Material material = refracts ? test::random_dielectric(generator, strata, 0.1)
                                           : test::random_conductor(generator, strata, 0.1);
        const auto surface = prepared(material);
        const auto expected = reference::prepare_microsurface_stochastic(material);
        const auto next = [&] {
            vec3 w =
                direction(std::acos(0.05 + 0.95 * uniform(generator)), 6.28 * uniform(generator));
            if (refracts && uniform(generator) < 0.4) w.z = -w.z;
            return w;
        };
        for (int k = 0; k < per_surface; ++k) {
            const vec3 wi = next(), wo = next();
            errors.push_back(error(surface, expected, wi, wo, static_cast<std::uint32_t>(k)));
        }
    }
    std::ranges::sort(errors);
    return errors;
}

double relative_error(const vec3& value, const glm::dvec3& expected) {
    double most = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double error = std::abs(static_cast<double>(value[c]) - expected[c]) /
                             std::max(std::abs(expected[c]), kSmallValue);
        // Written so that NaN counts as wrong.
        most = error <= most ? most : error;
    }
    return most;
}

// In double only the shaders' polynomials differ, by up to 5e-7 each: some ten of them, one after
// the other, on the way of a walk. In float a facet multiplies an error of a direction by up to
// 2 / alpha, and a walk that chance sends elsewhere because of one has nothing in common with the
// reference's any more: of walks that meet n facets some n 3 2^-24 / alpha do.
#ifdef LACQUER_TEST_FLOAT
constexpr double kMedian = 5e-7, kMost = 1e-4, kElsewhere = 2e-3;
#else
constexpr double kMedian = 1e-8, kMost = 1e-5, kElsewhere = 2e-4;
#endif

double quantile(const std::vector<double>& errors, double share) {
    return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
}

TEST(MicrosurfaceStochastic, EvaluatesWhatTheReferenceDoes) {
    const auto errors = errors_over_surfaces(
        24, 1000,
        [](const auto& surface, const auto& expected, const vec3& wi, const vec3& wo,
           std::uint32_t seed) {
            return relative_error(shader::lq_microsurface_stochastic_eval(surface, wi, wo, seed),
                                  eval(expected, widen(wi), widen(wo), seed));
        });
    EXPECT_LE(quantile(errors, 0.5), kMedian);
    EXPECT_LE(quantile(errors, 1.0 - kElsewhere), kMost);
}

TEST(MicrosurfaceStochastic, SamplesWhatTheReferenceDoes) {
    std::mt19937_64 generator{20230906};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};
    const auto errors = errors_over_surfaces(
        24, 200,
        [&](const auto& surface, const auto& expected, const vec3&, const vec3& wo,
            std::uint32_t seed) {
            const vec3 u{real(uniform(generator)), real(uniform(generator)),
                         real(uniform(generator))};
            const auto chosen = shader::lq_microsurface_stochastic_sample(surface, wo, u, seed);
            const auto wanted = sample(expected, widen(wo), widen(u), seed);
            const double pdf = relative_error(vec3{chosen.pdf}, glm::dvec3{wanted.pdf});
            return std::max({relative_error(chosen.wi, wanted.wi), pdf,
                             relative_error(chosen.weight, wanted.weight)});
        });
    // Directions are computed, too, and f answers to them.
    EXPECT_LE(quantile(errors, 0.5), 10.0 * kMedian);
    EXPECT_LE(quantile(errors, 0.99), 10.0 * kMost);
}

TEST(MicrosurfaceStochastic, HasTheAlbedoOfTheReference) {
    const auto errors = errors_over_surfaces(
        3, 1,
        [](const auto& surface, const auto& expected, const vec3&, const vec3& wo,
           std::uint32_t seed) {
            const auto light =
                shader::lq_microsurface_stochastic_albedo(surface, wo, 1 << 14, seed);
            const auto wanted = albedo(expected, widen(wo), seed);
            return glm::length(widen(light.direct + light.base) - wanted.direct - wanted.base) +
                   glm::length(widen(light.transmitted) - wanted.transmitted);
        });
    EXPECT_LE(errors.back(), 4e-3);  // of points even to 1 / sqrt(n) where a sample jumps
}

TEST(MicrosurfaceStochastic, IsFiniteEverywhere) {
    std::mt19937_64 generator{20230907};
    for (int n = 0; n < 8; ++n) {
        const Material material = n % 2 == 0 ? test::random_conductor(generator, 1 + n / 2, 0.0)
                                             : test::random_dielectric(generator, 1 + n / 2, 0.0);
        const auto surface = prepared(material);
        for (const double cosine : {1.0, 0.3, 1e-6, 1e-30, 0.0, -1e-6, -0.5})
            for (const double other : {1.0, 0.3, 1e-6, 1e-30, 0.0, -1e-6, -0.5})
                for (std::uint32_t seed = 0; seed < 20; ++seed) {
                    vec3 wo = direction(std::acos(std::abs(cosine)), 0.4);
                    vec3 wi = direction(std::acos(std::abs(other)), 3.0);
                    wo.z = real(cosine);
                    wi.z = real(other);
                    const vec3 f = shader::lq_microsurface_stochastic_eval(surface, wi, wo, seed);
                    const auto chosen = shader::lq_microsurface_stochastic_sample(
                        surface, wo, {real(0.4), real(0.3), real(0.999)}, seed);
                    for (const Real value : {f.x, f.y, f.z, chosen.pdf, chosen.weight.x}) {
                        EXPECT_TRUE(std::isfinite(value)) << cosine << " " << other;
                        EXPECT_GE(value, 0) << cosine << " " << other;
                    }
                }
    }
}

}  // namespace
}  // namespace lacquer::shader_test
