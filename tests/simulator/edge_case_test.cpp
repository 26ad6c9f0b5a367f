// The ends of every range: no walk may produce a NaN, run for ever or lose light that is not
// absorbed.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "simulator/albedo.h"
#include "simulator/interface.h"
#include "simulator/stack.h"

namespace lacquer::simulator {
namespace {

constexpr double kRounding = 1e-12;

constexpr double kGrazing[] = {1.0, 0.3, 1e-3, 1e-9, 1e-15, 0.0};

Material interface_material(double ior, const Roughness& roughness) {
    Material material;
    material.layers = {{{ior, roughness}, AbsorbingMedium{}}};
    material.base = NoBase{};
    return material;
}

double reflected_or_transmitted(const Material& material, double cos_theta) {
    const AlbedoEstimate result = estimate_albedo(StackWalk{material}, cos_theta, {2'000, 1, {}});
    return result.total.mean[0] + result.transmitted.mean[0];
}

Blend blend(Blend::Operator op, const Microsurface& top, const Microsurface& bottom) {
    return {op, {{0.3, top, {}, {}, {}}, {0.7, bottom, {}, {}, {}}}};
}

TEST(EdgeCases, DielectricInterfacesLoseNoLightFromAnyDirection) {
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        for (const auto& alpha : {std::array{0.0, 0.0},
                                  {0.0, 0.5},
                                  {1e-9, 1e-9},
                                  {1e-4, 1.0},
                                  {0.02, 0.02},
                                  {1.0, 1.0}})
            for (const double eta : {1.0 / 3, 1.0, 3.0})
                for (const double cosine : kGrazing)
                    EXPECT_NEAR(reflected_or_transmitted(
                                    interface_material(eta, Microsurface{ndf, alpha}), cosine),
                                1.0, kRounding)
                        << "alpha " << alpha[0] << " " << alpha[1] << " eta " << eta << " cosine "
                        << cosine;
}

TEST(EdgeCases, BlendsWithFlatFacetsLoseNoLight) {
    const Microsurface flat{Ndf::ggx, {0.0, 0.0}};
    for (const auto op : {Blend::Operator::symmetric, Blend::Operator::asymmetric})
        for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann}) {
            const Microsurface rough{ndf, {0.7, 0.4}};
            for (const Blend& surface :
                 {blend(op, flat, rough), blend(op, rough, flat), blend(op, flat, flat)})
                for (const double cosine : kGrazing)
                    EXPECT_NEAR(reflected_or_transmitted(interface_material(1.5, surface), cosine),
                                1.0, kRounding);
        }
}

TEST(EdgeCases, FlatBlendReflectsAsOneSmoothInterface) {
    const Microsurface flat{Ndf::ggx, {0.0, 0.0}};
    const AlbedoEstimate result = estimate_albedo(
        StackWalk{interface_material(1.5, blend(Blend::Operator::asymmetric, flat, flat))}, 0.4,
        {100'000, 2, {}});
    constexpr double kSigmas = 3.5;  // one comparison at a significance below 0.001
    EXPECT_NEAR(result.total.mean[0], dielectric_reflectance(0.4, 1.5),
                kSigmas * result.total.standard_error[0]);
    EXPECT_EQ(result.orders[1].mean[0], 0.0);
}

TEST(EdgeCases, AllLightComesBackThroughEveryLosslessMedium) {
    for (const double g : {-0.99, 0.0, 1e-7, 0.99})
        for (const double thickness : {0.0, 1e-6, 5.0})
            for (const double cosine : {1.0, 1e-9, 0.0}) {
                Material material;
                material.layers = {
                    {{1.0, Microsurface{}}, ScatteringMedium{{}, {1.0, 1.0, 1.0}, g, thickness}}};
                material.base = LambertianBase{{1.0, 1.0, 1.0}};
                const AlbedoEstimate result =
                    estimate_albedo(StackWalk{material}, cosine, {1'000, 3, {}});
                EXPECT_NEAR(result.total.mean[0], 1.0, kRounding) << g << " " << thickness;
            }
}

TEST(EdgeCases, InterfaceOfEqualIndicesDoesNothingFromAnyDirection) {
    for (const double alpha : {0.0, 0.7})
        for (const double cosine : {1.0, 1e-9, 0.0}) {
            const InterfaceEstimate result =
                estimate_interface({Ndf::ggx, alpha, alpha}, 1.0, 1.0, cosine, {1'000, 6, {}});
            EXPECT_EQ(result.t_down.mean, 1.0) << cosine;
            EXPECT_EQ(result.t_up.mean, 1.0) << cosine;
        }
}

TEST(EdgeCases, OpaqueMediumHidesTheBase) {
    Material material;
    material.layers = {
        {{1.5, Microsurface{Ndf::ggx, {0.2, 0.2}}}, AbsorbingMedium{{0.0, 1.0, 0.0}}}};
    material.base = LambertianBase{{1.0, 1.0, 1.0}};
    const AlbedoEstimate result = estimate_albedo(StackWalk{material}, 0.6, {2'000, 4, {}});
    EXPECT_EQ(result.base.mean[0], 0.0);
    EXPECT_NEAR(result.total.mean[1], 1.0, kRounding);
}

TEST(EdgeCases, ExtremeMetalsReflectAtMostAllLight) {
    for (const double eta : {0.0, 5.0})
        for (const double kappa : {0.0, 10.0})
            for (const double cosine : kGrazing) {
                Material material;
                material.base = ConductorBase{
                    {eta, eta, eta}, {kappa, kappa, kappa}, Microsurface{Ndf::ggx, {0.5, 0.5}}};
                const AlbedoEstimate result =
                    estimate_albedo(StackWalk{material}, cosine, {2'000, 5, {}});
                EXPECT_LE(result.total.mean[0], 1.0 + kRounding);
                EXPECT_GE(result.total.mean[0], 0.0);
            }
}

TEST(Estimator, ResultIsTheSameForAnyNumberOfThreads) {
    Material material = interface_material(1.5, Microsurface{Ndf::ggx, {0.4, 0.4}});
    std::get<AbsorbingMedium>(material.layers[0].medium).tau = {0.3, 0.6, 0.9};
    const StackWalk stack{material};
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit{tbb::global_control::max_allowed_parallelism, threads};
        return estimate_albedo(stack, 0.5, {60'000, 7, {}});
    };
    const AlbedoEstimate one = run(1);
    for (const std::size_t threads : {2, 3, 8}) {
        const AlbedoEstimate many = run(threads);
        EXPECT_EQ(one.transmitted.mean, many.transmitted.mean);
        EXPECT_EQ(one.transmitted.standard_error, many.transmitted.standard_error);
        EXPECT_EQ(one.samples, many.samples);
    }
}

}  // namespace
}  // namespace lacquer::simulator
