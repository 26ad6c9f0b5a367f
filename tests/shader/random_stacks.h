// Random stacks, as the reference and as the shader source take them.
#pragma once

#include <cmath>
#include <filesystem>
#include <random>
#include <variant>
#include <vector>

#include "lacquer/material.h"
#include "shader.h"
#include "tables/energy_tables.h"

namespace lacquer::test {

inline const EnergyTables& tables() {
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

inline shader::vec3 to_vec(const Rgb& rgb) {
    return shader::vec3{rgb[0], rgb[1], rgb[2]};
}

inline shader::LqFacets to_facets(const Microsurface& facets) {
    return {facets.ndf == Ndf::ggx ? shader::LQ_NDF_GGX : shader::LQ_NDF_BECKMANN,
            static_cast<shader::Real>(facets.alpha[0]), static_cast<shader::Real>(facets.alpha[1])};
}

inline std::vector<shader::vec4> to_rows(const Material& material) {
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

}  // namespace lacquer::test
