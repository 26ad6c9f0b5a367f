// Stacks as the shader source takes them, and its two ways to shade them under the same names.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <variant>
#include <vector>

#include "lacquer/material.h"
#include "reference/stack/stack.h"
#include "shader.h"
#include "support/random_stacks.h"
#include "tables/energy_tables.h"

namespace lacquer::test {

inline const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

inline RandomStacks random_stacks() {
    return RandomStacks{{20180812, -0.5, true}};
}

// Every second interface a blend.
inline RandomStacks random_blends() {
    return RandomStacks{{20230806, -0.5, true, true}};
}

inline shader::vec3 to_vec(const Rgb& rgb) {
    return shader::vec3{rgb[0], rgb[1], rgb[2]};
}

inline shader::LqFacets to_facets(const Microsurface& facets) {
    return {facets.ndf == Ndf::ggx ? shader::LQ_NDF_GGX : shader::LQ_NDF_BECKMANN,
            static_cast<shader::Real>(facets.alpha[0]), static_cast<shader::Real>(facets.alpha[1])};
}

inline std::vector<shader::vec4> to_rows(const Material& material) {
    std::vector<shader::vec4> rows, strata;
    for (const Layer& layer : material.layers) {
        double first_stratum = 0.0;
        if (const auto* blend = std::get_if<Blend>(&layer.interface.roughness)) {
            first_stratum = static_cast<double>(3 * material.layers.size() + strata.size());
            rows.emplace_back(blend->strata.size(),
                              blend->op == Blend::Operator::symmetric ? shader::LQ_BLEND_SYMMETRIC
                                                                      : shader::LQ_BLEND_ASYMMETRIC,
                              layer.interface.ior, shader::LQ_STACK_BLENDED);
            for (const Stratum& stratum : blend->strata) {
                const shader::LqFacets facets = to_facets(stratum.microsurface);
                strata.emplace_back(facets.alpha_x, facets.alpha_y, stratum.weight, facets.ndf);
            }
        } else {
            const auto& facets = std::get<Microsurface>(layer.interface.roughness);
            rows.emplace_back(facets.alpha[0], facets.alpha[1], layer.interface.ior,
                              to_facets(facets).ndf);
        }
        if (const auto* absorbing = std::get_if<AbsorbingMedium>(&layer.medium)) {
            const Rgb& tau = absorbing->tau;
            rows.emplace_back(-std::log(tau[0]), -std::log(tau[1]), -std::log(tau[2]), 0.0);
            rows.emplace_back(0.0, 0.0, 0.0, first_stratum);
        } else {
            const auto& slab = std::get<ScatteringMedium>(layer.medium);
            rows.emplace_back(to_vec(slab.sigma_a), slab.g);
            rows.emplace_back(to_vec(slab.sigma_s), first_stratum);
        }
    }
    rows.insert(rows.end(), strata.begin(), strata.end());
    return rows;
}

// Of the rows that shader::stack_rows points to.
inline shader::LqStackMaterial to_stack(const Material& material) {
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
    return stack;
}

inline double relative_error(double value, double expected) {
    return std::abs(value - expected) / (std::abs(expected) + 1e-9);
}

// In double thresholds and quotients of small numbers leave of f and pdf what is here; in float,
// rounding grows along the transport and by the fourth power of a lobe's slope.
#ifdef LACQUER_TEST_FLOAT
inline constexpr double kRelative = 3e-3;
inline constexpr double kDirection = 1e-3;
#else
// Beckmann's masking is a fit to 1e-7, GGX alone needs 1e-9; its normals come from a fit of the
// inverse of erf.
inline constexpr double kRelative = 2e-7;
inline constexpr double kDirection = 2e-7;
#endif

// The shader's functions are compiled anew for every test, with the choices made there.
namespace {

struct Forward {
    static constexpr reference::StackLobes kLobes = reference::StackLobes::forward;
    static constexpr auto prepare = shader::lq_stack_prepare;
    static constexpr auto eval = shader::lq_stack_eval;
    static constexpr auto pdf = shader::lq_stack_pdf;
    static constexpr auto sample = shader::lq_stack_sample;
    static constexpr auto albedo = shader::lq_stack_albedo;
#ifdef LACQUER_TEST_FLOAT
    static constexpr double kTypical = 1e-6;  // the median of f and pdf
    static constexpr double kEnergy = 2e-6;
#else
    static constexpr double kTypical = 1e-11;
    static constexpr double kEnergy = 1e-10;
#endif
};

// Whose albedos are cubics through four directions, of which the first, at grazing, has the fewest
// digits.
struct Symmetric {
    static constexpr reference::StackLobes kLobes = reference::StackLobes::symmetric;
    static constexpr auto prepare = shader::lq_stack_symmetric_prepare;
    static constexpr auto eval = shader::lq_stack_symmetric_eval;
    static constexpr auto pdf = shader::lq_stack_symmetric_pdf;
    static constexpr auto sample = shader::lq_stack_symmetric_sample;
    static constexpr auto albedo = shader::lq_stack_symmetric_albedo;
#ifdef LACQUER_TEST_FLOAT
    static constexpr double kTypical = 1e-6;
    static constexpr double kEnergy = 5e-6;
#else
    static constexpr double kTypical = 1e-10;
    static constexpr double kEnergy = 1e-9;
#endif
};

// Prepares random stacks, one at a time.
template <typename Model>
class RandomStackTest : public testing::Test {
 public:
    // The material's surface, whose rows stay until the next.
    auto prepared(const Material& material) {
        rows_ = to_rows(material);
        shader::stack_rows = rows_.data();
        return Model::prepare(to_stack(material));
    }

    explicit RandomStackTest(const RandomStacks& random = random_stacks()) : random_{random} {}

    RandomStacks random_;

 private:
    std::vector<shader::vec4> rows_;
};

template <typename Model>
struct RandomBlendTest : RandomStackTest<Model> {
    RandomBlendTest() : RandomStackTest<Model>{random_blends()} {}
};

using StackModels = testing::Types<Forward, Symmetric>;

}  // namespace

}  // namespace lacquer::test
