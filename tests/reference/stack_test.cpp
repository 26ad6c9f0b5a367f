// The model `stack` in double precision: closed forms of smooth stacks, white furnaces, and what it
// promises of its functions.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "core/error.h"
#include "reference/coated.h"
#include "reference/stack/stack.h"
#include "support/sampling_fit.h"
#include "support/smooth_dielectric.h"

namespace lacquer {
namespace {

using reference::prepare_stack;

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

glm::dvec3 direction(double cos_theta) {
    return {std::sqrt(1.0 - cos_theta * cos_theta), 0.0, cos_theta};
}

Layer layer(double ior, double alpha, double tau) {
    return {{ior, Microsurface{Ndf::ggx, {alpha, alpha}}}, AbsorbingMedium{{tau, tau, tau}}};
}

ConductorBase conductor(double eta, double kappa, double alpha) {
    return {{eta, eta, eta}, {kappa, kappa, kappa}, Microsurface{Ndf::ggx, {alpha, alpha}}};
}

glm::dvec3 total_albedo(const Material& material, double cos_theta) {
    const auto surface = prepare_stack(material, tables());
    const reference::Albedo albedo = reference::albedo(surface, direction(cos_theta));
    return albedo.direct + albedo.base;
}

// Reflectance of a smooth conductor for unpolarised light; Born and Wolf 1999, section 14.2.
double conductor_reflectance(double cos_i, std::complex<double> eta) {
    const std::complex<double> cos_t = std::sqrt(1.0 - (1.0 - cos_i * cos_i) / (eta * eta));
    const auto s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t);
    const auto p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
    return 0.5 * (std::norm(s) + std::norm(p));
}

// Of a stack of smooth interfaces, from the bottom up: each adds r + t^2 tau^2 R / (1 - r R tau^2),
// where what lies below reflects R. The same from above and below by Fresnel's equations.
double smooth_albedo(const Material& material, double cos_theta) {
    std::vector<double> iors{1.0};
    for (const Layer& at : material.layers) iors.push_back(at.interface.ior);
    const auto cosine = [&](std::size_t medium) {
        return std::sqrt(1.0 - (1.0 - cos_theta * cos_theta) / (iors[medium] * iors[medium]));
    };
    double below = 0.0;
    if (const auto* base = std::get_if<ConductorBase>(&material.base))
        below = conductor_reflectance(cosine(iors.size() - 1),
                                      std::complex{base->eta[0], base->kappa[0]} / iors.back());
    for (std::size_t n = material.layers.size(); n-- > 0;) {
        const double tau = std::get<AbsorbingMedium>(material.layers[n].medium).tau[0];
        const double seen = below * std::pow(tau, 2.0 / cosine(n + 1));
        const double r = test::smooth_reflectance(cosine(n), iors[n + 1] / iors[n]);
        below = r + (1.0 - r) * (1.0 - r) * seen / (1.0 - r * seen);
    }
    return below;
}

void expect_smooth_albedos(const Material& material) {
    constexpr double kExact = 1e-4;
    for (const double cos_theta : {0.05, 0.2, 0.5, 0.8, 1.0})
        EXPECT_NEAR(total_albedo(material, cos_theta).x, smooth_albedo(material, cos_theta), kExact)
            << material.layers.size() << " layers, cos " << cos_theta;
}

// That smooth interfaces over a smooth conductor, and over nothing, reflect what the Fresnel
// equations and a geometric series per layer say.
TEST(Stack, SmoothStacksAreExact) {
    const std::vector<Layer> layers{layer(1.5, 0.0, 0.9), layer(2.0, 0.0, 0.6),
                                    layer(1.2, 0.0, 1.0), layer(1.7, 0.0, 0.8)};
    for (std::size_t count = 1; count <= layers.size(); ++count) {
        Material material;
        material.layers.assign(layers.begin(), layers.begin() + static_cast<long>(count));
        material.base = conductor(0.2, 3.9, 0.0);
        expect_smooth_albedos(material);
        material.base = NoBase{};
        expect_smooth_albedos(material);
    }
}

// That eight layers of strong contrast, between which light goes back and forth for long, converge.
TEST(Stack, EightSmoothLayersAreExact) {
    Material material;
    for (int n = 0; n < 4; ++n) {
        material.layers.push_back(layer(2.5, 0.0, 1.0));
        material.layers.push_back(layer(1.0, 0.0, 1.0));
    }
    material.base = conductor(0.1, 5.0, 0.0);
    expect_smooth_albedos(material);
}

// That a stack of one coat over a Lambertian base is `coated`, which is exact to 0.002 in the mean.
TEST(Stack, OneCoatOverLambertianIsCoated) {
    constexpr double kOneCoatError = 0.02;  // measured: absorption of light on its way in
    for (const double alpha : {0.0, 0.1, 0.4, 0.8})
        for (const double ior : {1.2, 1.5, 2.0})
            for (const double cos_theta : {0.1, 0.5, 1.0}) {
                Material material;
                material.layers = {layer(ior, alpha, 0.7)};
                material.base = LambertianBase{{0.8, 0.5, 0.2}};
                const glm::dvec3 wo = direction(cos_theta);
                const auto one = reference::albedo(
                    reference::prepare_coated(material, tables(), reference::BaseLobe::exact), wo);
                const glm::dvec3 stack = total_albedo(material, cos_theta);
                for (int channel = 0; channel < 3; ++channel)
                    EXPECT_NEAR(stack[channel], (one.direct + one.base)[channel], kOneCoatError)
                        << "ior " << ior << ", alpha " << alpha << ", cos " << cos_theta;
            }
}

// Five layers of index 1.3 and 1 in turn.
Material five_layers(const Base& base, double alpha) {
    Material material;
    for (int n = 0; n < 5; ++n)
        material.layers.push_back(layer(n % 2 == 0 ? 1.3 : 1.0, alpha, 1.0));
    material.base = base;
    return material;
}

// That nothing is lost or gained where nothing absorbs: over a mirror (a conductor of eta 0) and
// over a white Lambertian base. Belcour 2018, Fig. 12.
TEST(Stack, FiveLayersInAWhiteFurnace) {
    constexpr double kFurnace = 0.003;
    for (const double alpha : {0.0, 0.01, 0.1, 0.3, 0.6})
        for (const double cos_theta : {0.1, 0.4, 0.7, 1.0}) {
            EXPECT_NEAR(total_albedo(five_layers(conductor(0.0, 5.0, alpha), alpha), cos_theta).x,
                        1.0, kFurnace)
                << "mirror, alpha " << alpha << ", cos " << cos_theta;
        }
}

// That `sample` draws from `pdf`.
TEST(Stack, SamplesFitTheirDensity) {
    Material material;
    material.layers = {layer(1.5, 0.3, 0.8), layer(1.2, 0.2, 0.9)};
    material.base = conductor(0.2, 3.9, 0.4);
    const auto surface = prepare_stack(material, tables());
    const auto seen = reference::view(surface, direction(0.6));
    const test::Sampler sampler = [&](const glm::dvec3& u) -> std::optional<glm::dvec3> {
        const reference::Sample sample = reference::sample(seen, u);
        if (sample.pdf <= 0.0) return std::nullopt;
        return sample.wi;
    };
    test::expect_sampling_fit(
        sampler, [&](const glm::dvec3& wi) { return reference::pdf(seen, wi); }, 1e-3,
        "two coats over a conductor");
}

TEST(Stack, RefusesWhatItCannotShade) {
    Material bare;
    bare.base = conductor(0.2, 3.9, 0.4);
    EXPECT_THROW(prepare_stack(bare, tables()), Error);
    Material diffuse;
    diffuse.layers = {layer(1.5, 0.1, 1.0)};
    diffuse.base = DiffuseFacetsBase{};
    EXPECT_THROW(prepare_stack(diffuse, tables()), Error);
}

// That media which scatter and do not absorb keep all light over a white base.
TEST(Stack, CloudyLayersInAWhiteFurnace) {
    constexpr double kFurnace = 0.003;
    Material material;
    material.layers = {layer(1.5, 0.2, 1.0), layer(1.3, 0.3, 1.0)};
    material.layers[0].medium = ScatteringMedium{{}, {1.0, 1.0, 1.0}, 0.7, 1.0};
    material.layers[1].medium = ScatteringMedium{{}, {0.5, 0.5, 0.5}, 0.2, 2.0};
    for (const Base& base : {Base{LambertianBase{{1.0, 1.0, 1.0}}}, Base{conductor(0, 5, 0.2)}}) {
        material.base = base;
        for (const double cos_theta : {0.2, 0.5, 1.0})
            EXPECT_NEAR(total_albedo(material, cos_theta).x, 1.0, kFurnace) << cos_theta;
    }
}

}  // namespace
}  // namespace lacquer
