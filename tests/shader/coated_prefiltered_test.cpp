// The base's light under an environment in three functions of direction, against T01 itself.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "shader/shader.h"

namespace lacquer::shader_test {
namespace {

using shader::LqCoatedProfile;
using shader::LqCoatedSurface;

constexpr int kCosines = 4096;

LqCoatedSurface surface_of(double alpha, double eta, double tau) {
    const shader::LqFacets facets{shader::LQ_NDF_GGX, real(alpha), real(alpha)};
    return shader::lq_coated_prepare(
        {facets, real(eta), vec3{real(tau)}, vec3{real(0.8)}, shader::LQ_BASE_LOBE_EXACT});
}

double profile_at(const LqCoatedProfile& profile, double c) {
    return profile.mean.x + profile.slope.x * (3.0 * c - 2.0) +
           profile.curvature.x * (10.0 * c * c - 12.0 * c + 3.0);
}

double t_down_at(const LqCoatedSurface& surface, double c) {
    return shader::lq_interface_t_down(surface.energies, real(c)).x;
}

// Half the integral of |a - b| c dc over that of b c dc: how much of the light is misplaced.
template <typename A, typename B>
double distance(const A& a, const B& b) {
    double difference = 0.0, light = 0.0;
    for (int n = 0; n < kCosines; ++n) {
        const double c = (n + 0.5) / kCosines;
        difference += 0.5 * std::abs(a(c) - b(c)) * c;
        light += b(c) * c;
    }
    return difference / light;
}

struct Surfaces {
    std::mt19937 random{1};
    std::uniform_real_distribution<double> uniform{0.0, 1.0};

    LqCoatedSurface next(double least_eta, double most_eta) {
        const double eta =
            std::exp(std::lerp(std::log(least_eta), std::log(most_eta), uniform(random)));
        return surface_of(uniform(random), eta, 0.1 + 0.9 * uniform(random));
    }
};

struct Distances {
    double mean = 0.0, largest = 0.0;
    double mean_of_one = 0.0;  // of the first function alone: T01 taken as diffuse
};

Distances distances(double least_eta, double most_eta) {
    constexpr int kSurfaces = 300;
    Surfaces surfaces;
    Distances result;
    for (int n = 0; n < kSurfaces; ++n) {
        const LqCoatedSurface surface = surfaces.next(least_eta, most_eta);
        const LqCoatedProfile profile = shader::lq_coated_profile(surface);
        const auto truth = [&](double c) { return t_down_at(surface, c); };
        const double three = distance([&](double c) { return profile_at(profile, c); }, truth);
        const double one = distance([&](double) { return double{profile.mean.x}; }, truth);
        result.mean += three / kSurfaces;
        result.mean_of_one += one / kSurfaces;
        result.largest = std::max(result.largest, three);
    }
    fmt::print("eta {} to {}: {:.4f} in the mean, at most {:.4f}; as diffuse light {:.4f}\n",
               least_eta, most_eta, result.mean, result.largest, result.mean_of_one);
    return result;
}

// The coefficients are those of least squares with weight c: what is left has no integral against
// any of the functions.
TEST(CoatedPrefiltered, WhatIsLeftIsOrthogonalToTheFunctions) {
    // Of a midpoint rule over functions whose slope is infinite at the critical angle: half of its
    // error has the order of a cell to the power of 3/2.
    const double quadrature = 4.0 * std::pow(kCosines, -1.5);
    Surfaces surfaces;
    for (int n = 0; n < 200; ++n) {
        const LqCoatedSurface surface = surfaces.next(0.34, 2.99);
        const LqCoatedProfile profile = shader::lq_coated_profile(surface);
        std::array<double, 3> left{};
        for (int i = 0; i < kCosines; ++i) {
            const double c = (i + 0.5) / kCosines;
            // Before it is clamped to [0, 1].
            const double t_down = shader::lq_direction_values(surface.energies.transmission,
                                                              surface.energies.critical, real(c))
                                      .x;
            const double rest = (t_down - profile_at(profile, c)) * c / kCosines;
            left[0] += rest;
            left[1] += rest * (3.0 * c - 2.0);
            left[2] += rest * (10.0 * c * c - 12.0 * c + 3.0);
        }
        for (const double integral : left)
            EXPECT_NEAR(integral, 0.0, quadrature + roundings(400)) << surface.eta;
    }
}

TEST(CoatedPrefiltered, WhiteLightGivesTheAlbedo) {
    Surfaces surfaces;
    for (int n = 0; n < 200; ++n) {
        const LqCoatedSurface surface = surfaces.next(0.34, 2.99);
        const auto viewer = shader::lq_coated_view(surface, direction(0.7, 0.0));
        const vec3 pi{real(3.14159265358979)};
        const vec3 light = shader::lq_coated_base_prefiltered(
            surface, viewer, shader::lq_coated_profile(surface), pi, vec3{0}, vec3{0});
        EXPECT_NEAR(light.x, viewer.base.x, roundings(400));
    }
}

// Three functions place the light better than one, by far where there is no critical angle.
TEST(CoatedPrefiltered, ThreeFunctionsPlaceMostOfTheLight) {
    // What the head of coated/prefiltered.glsl and the README say.
    const Distances dense = distances(1.0, 3.0);
    EXPECT_LT(dense.mean, 0.0045);
    EXPECT_LT(dense.largest, 0.02);
    const Distances thin = distances(0.34, 1.0);
    EXPECT_LT(thin.mean, 0.125);
    EXPECT_LT(thin.mean, thin.mean_of_one);
}

}  // namespace
}  // namespace lacquer::shader_test
