// Algorithm 1 of 2022 where its equations can be followed by hand.
#include "reference/stack/published/algorithm_1_2022.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "support/smooth_dielectric.h"

namespace lacquer {
namespace {

namespace p2022 = reference::published_2022;
using p2022::Below;
using reference::StackLayers;

constexpr double kRounding = 1e-9;
constexpr double kTables = 2e-3;  // between two look-ups of one energy
const glm::dvec3 kAlbedo{0.9, 0.5, 0.1};

const EnergyTables& tables() {
    static const EnergyTables all{std::filesystem::path{BAKED_TABLES}};
    return all;
}

Layer layer(double ior, double alpha, const Rgb& tau = {1.0, 1.0, 1.0}) {
    return {{ior, Microsurface{Ndf::ggx, {alpha, alpha}}}, AbsorbingMedium{tau}};
}

StackLayers stack(std::vector<Layer> layers) {
    Material material;
    material.name = "stack";
    material.layers = std::move(layers);
    material.base = LambertianBase{{kAlbedo.x, kAlbedo.y, kAlbedo.z}};
    return reference::prepare_layers(material, tables());
}

// Eq. 3.
double coated(double cosine, double alpha, double eta, double tau, double rho) {
    return tables().t_down(cosine, alpha, eta, tau) * rho /
           (1.0 - rho * tables().r_up(alpha, eta, tau)) * tables().t_up(alpha, eta, tau);
}

double roughness(const p2022::DiffuseLobe& lobe) {
    return lobe.shape.facets.alpha_x;
}

// Eqs. 9 and 11.
TEST(Published2022, OneCoatIsTheCoatedLambertian) {
    const Rgb tau{0.9, 0.6, 0.4};
    for (const auto& [ior, alpha] : {std::pair{1.5, 0.3}, {0.8, 0.1}, {2.0, 0.0}})
        for (const Below below : {Below::next_interface, Below::all}) {
            const auto lobe =
                p2022::diffuse_lobe(stack({layer(ior, alpha, tau)}), kAlbedo, 0.6, below);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(lobe.energy[c],
                            coated(0.6, alpha, ior, tau[static_cast<std::size_t>(c)], kAlbedo[c]),
                            kRounding);
            EXPECT_NEAR(roughness(lobe),
                        tables().equivalent_alpha(tables().variance(alpha, ior, 1.0)), kRounding);
        }
}

// A smooth coat of no index of its own reflects nothing and lets all through.
TEST(Published2022, AnIndexMatchedCoatDoesNothing) {
    for (const Below below : {Below::next_interface, Below::all}) {
        const auto alone = p2022::diffuse_lobe(stack({layer(1.5, 0.3)}), kAlbedo, 0.7, below);
        const auto under =
            p2022::diffuse_lobe(stack({layer(1.0, 0.0), layer(1.5, 0.3)}), kAlbedo, 0.7, below);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(under.energy[c], alone.energy[c], kTables);
        EXPECT_NEAR(roughness(under), roughness(alone), 0.02);
    }
}

// Eq. 12 of one smooth interface over the coated base: t_0 e t / (1 - e^2 r r_1), the transmittance
// upwards that of a lobe of alpha_2+.
TEST(Published2022, TwoSmoothCoatsByHand) {
    constexpr double kTop = 1.4, kInner = 1.8, kTau = 0.8, kCosine = 0.8;
    const StackLayers layers = stack({layer(kTop, 0.0, {kTau, kTau, kTau}), layer(kInner, 0.0)});
    const double inside = std::sqrt(1.0 - (1.0 - kCosine * kCosine) / (kTop * kTop));
    const double eta = kInner / kTop;
    const double down = 1.0 - test::smooth_reflectance(kCosine, kTop);
    const double alpha = tables().equivalent_alpha(tables().variance(0.0, eta, 1.0));
    const double up = tables().tir(1.0, alpha, 1.0 / kTop);
    const double next = test::smooth_reflectance(1.0, eta);
    const auto lobe = p2022::diffuse_lobe(layers, kAlbedo, kCosine, Below::next_interface);
    for (int c = 0; c < 3; ++c) {
        const double base = coated(inside, 0.0, eta, 1.0, kAlbedo[c]);
        const double arriving = down * std::pow(kTau, 1.0 / inside);
        const double expected =
            arriving * base * kTau * up / (1.0 - kTau * kTau * (1.0 - up) * next);
        EXPECT_NEAR(lobe.energy[c], expected, 1e-6);
    }
}

// Section 5: no variance above that of diffuse light through the interface.
TEST(Published2022, TheLobeIsNoWiderThanDiffuseLight) {
    for (const double ior : {0.8, 1.2, 1.6})
        for (const double alpha : {0.0, 0.4, 1.0}) {
            const auto lobe = p2022::diffuse_lobe(stack({layer(ior, alpha), layer(1.5, 0.8)}),
                                                  kAlbedo, 0.5, Below::all);
            EXPECT_LE(roughness(lobe),
                      tables().equivalent_alpha(tables().variance(alpha, ior, 1.0)) + kRounding);
        }
}

// What comes back from the base is light too.
TEST(Published2022, AllBelowReturnsMore) {
    const StackLayers layers = stack({layer(1.6, 0.0), layer(2.0, 0.1)});
    const auto printed = p2022::diffuse_lobe(layers, kAlbedo, 1.0, Below::next_interface);
    const auto all = p2022::diffuse_lobe(layers, kAlbedo, 1.0, Below::all);
    EXPECT_GT(all.energy.x, 1.2 * printed.energy.x);
    EXPECT_GT(all.energy.z, printed.energy.z);
    EXPECT_LT(all.energy.x, 1.0);
}

// The lobe of eval holds the energy.
TEST(Published2022, TheLobeIntegratesToItsEnergy) {
    constexpr int kSteps = 4000;
    const auto lobe =
        p2022::diffuse_lobe(stack({layer(1.3, 0.2), layer(1.5, 0.4)}), kAlbedo, 0.5, Below::all);
    glm::dvec3 all{0.0};
    for (int n = 0; n < kSteps; ++n) {
        const double z = (n + 0.5) / kSteps;
        all += p2022::eval(lobe, {std::sqrt(1.0 - z * z), 0.0, z}) * z * 2.0 * std::numbers::pi /
               double{kSteps};
    }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(all[c], lobe.energy[c], kTables * lobe.energy[c]);
    EXPECT_EQ(p2022::eval(lobe, {0.6, 0.0, -0.8}), glm::dvec3{0.0});
}

TEST(Published2022, RefusesMediaThatScatter) {
    Layer milky = layer(1.5, 0.1);
    milky.medium = ScatteringMedium{Rgb{}, {1.0, 1.0, 1.0}, 0.5, 1.0};
    EXPECT_THROW(p2022::diffuse_lobe(stack({milky}), kAlbedo, 0.5, Below::all), Error);
}

}  // namespace
}  // namespace lacquer
