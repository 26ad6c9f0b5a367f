// The simulator against what is known in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "simulator/albedo.h"
#include "simulator/interface.h"

namespace lacquer::simulator {
namespace {

// Standard errors that a correct estimate keeps within, for all tests of this file together: about
// 200 comparisons at a suite significance of 0.01.
constexpr double kSigmas = 4.1;

Layer clear_layer(double ior, double alpha, Ndf ndf = Ndf::ggx) {
    return {{ior, Microsurface{ndf, {alpha, alpha}}}, AbsorbingMedium{}};
}

Material over_lambertian(std::vector<Layer> layers, double albedo) {
    Material material;
    material.layers = std::move(layers);
    material.base = LambertianBase{{albedo, albedo, albedo}};
    return material;
}

TEST(Interface, ReflectsOrTransmitsEverything) {
    for (const double eta : {1.0 / 3, 0.8, 1.5, 3.0})
        for (const double alpha : {0.0, 0.05, 0.5, 1.0})
            for (const double cosine : {1.0, 0.5, 0.05}) {
                const auto result =
                    estimate_interface({Ndf::ggx, alpha, alpha}, eta, 1.0, cosine, {20'000, 1, {}});
                EXPECT_NEAR(result.t_down.mean + result.fgd.mean, 1.0, 1e-12);
                EXPECT_NEAR(result.t_up.mean + result.r_up.mean, 1.0, 1e-12);
            }
}

TEST(Interface, SmoothDielectricHasItsFresnelReflectance) {
    for (const double eta : {0.7, 1.5, 2.5})
        for (const double cosine : {1.0, 0.7, 0.2}) {
            const auto result = estimate_interface({}, eta, 1.0, cosine, {200'000, 2, {}});
            EXPECT_NEAR(result.fgd.mean, dielectric_reflectance(cosine, eta),
                        kSigmas * result.fgd.standard_error + 1e-12);
        }
}

TEST(Interface, DiffuseInternalReflectanceOfSmoothGlass) {
    // Duntley's closed form at 1.5.
    const auto result = estimate_interface({}, 1.5, 1.0, 1.0, {2'000'000, 3, {}});
    EXPECT_NEAR(result.r_up.mean, 0.59635, kSigmas * result.r_up.standard_error);
}

TEST(Interface, DiffuseTransmittancesObeyReciprocity) {
    // T_bar(down) = eta^2 T_bar(up); down averaged over a cosine-weighted hemisphere of cosines.
    for (const double eta : {0.8, 1.5, 2.0})
        for (const double alpha : {0.3, 1.0}) {
            const SurfaceWalk surface{
                Surface{Blend::Operator::asymmetric,
                        {{1.0, {Ndf::ggx, alpha, alpha}, DielectricFacet{eta}}}}};
            struct Tally {
                Moments down;
                std::uint64_t count = 0;
                void merge(const Tally& other) { down.merge(other.down); }
            };
            constexpr std::uint64_t kWalks = 1'000'000;
            const auto tally =
                run_walks<Tally>({kWalks, 4, {}}, [&](RandomStream& random, Tally& sum) {
                    const double squared = random.uniform();
                    const Vec3 w{std::sqrt(squared), 0.0, -std::sqrt(1.0 - squared)};
                    sum.down.add(surface.cross(w, random).below ? 1.0 : 0.0);
                });
            const auto up =
                estimate_interface({Ndf::ggx, alpha, alpha}, eta, 1.0, 1.0, {kWalks, 5, {}});
            const double error =
                std::hypot(tally.down.standard_error(kWalks), eta * eta * up.t_up.standard_error);
            EXPECT_NEAR(tally.down.mean(kWalks), eta * eta * up.t_up.mean, kSigmas * error)
                << eta << " " << alpha;
        }
}

TEST(Stack, WhiteLambertianReturnsAllLightUnderAnyClearStack) {
    for (const Ndf ndf : {Ndf::ggx, Ndf::beckmann})
        for (const auto& layers :
             {std::vector<Layer>{},
              {clear_layer(1.5, 0.3, ndf)},
              {clear_layer(0.7, 0.1, ndf)},
              {clear_layer(1.6, 0.2, ndf), clear_layer(1.2, 0.6, ndf), clear_layer(0.85, 0.0)}}) {
            const StackWalk stack{over_lambertian(layers, 1.0)};
            const AlbedoEstimate result = estimate_albedo(stack, 0.6, {50'000, 6, {}});
            EXPECT_NEAR(result.total.mean[1], 1.0, 1e-12);
        }
}

TEST(Stack, SmoothCoatOverLambertianMatchesTheClosedForm) {
    // theory: T(cos) rho (1 - R_bar) / eta^2-weighted escape: at eta 1.5, rho 0.5, cos 0.5: 0.2619.
    const StackWalk stack{over_lambertian({clear_layer(1.5, 0.0)}, 0.5)};
    const AlbedoEstimate result = estimate_albedo(stack, 0.5, {2'000'000, 7, {}});
    EXPECT_NEAR(result.base.mean[0], 0.2619, kSigmas * result.base.standard_error[0] + 5e-5);
}

TEST(Stack, SmoothPlateMatchesTheGeometricSeries) {
    // Two parallel faces, R each, tau per crossing: R + R T^2 t^2 / (1 - R^2 t^2).
    Material plate;
    const double tau = 0.7;
    plate.layers = {{{1.5, Microsurface{}}, AbsorbingMedium{{tau, tau, 1.0}}},
                    clear_layer(1.0, 0.0)};
    plate.base = NoBase{};
    const StackWalk stack{plate};
    for (const double cosine : {1.0, 0.4}) {
        const AlbedoEstimate result = estimate_albedo(stack, cosine, {1'000'000, 8, {}});
        const double r = dielectric_reflectance(cosine, 1.5);
        const double cos_inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / 2.25);
        const double t = std::pow(tau, 1.0 / cos_inside);
        const double series = 1.0 - r * r * t * t;
        const double reflected = r + r * (1 - r) * (1 - r) * t * t / series;
        const double transmitted = (1 - r) * (1 - r) * t / series;
        EXPECT_NEAR(result.direct.mean[0], reflected, kSigmas * result.direct.standard_error[0]);
        EXPECT_NEAR(result.transmitted.mean[0], transmitted,
                    kSigmas * result.transmitted.standard_error[0]);
        EXPECT_NEAR(result.direct.mean[2] + result.transmitted.mean[2], 1.0, 1e-12);
    }
}

TEST(Stack, ThinIsotropicScattererReflectsItsSingleScattering) {
    // Index-matched slab of small optical depth d: single scattering upwards is
    // d / (2 mu) * integral over mu' of ... -> to first order d / (2 mu) for g = 0 from mu.
    Material slab;
    const double depth = 1e-3;
    slab.layers = {{{1.0, Microsurface{}}, ScatteringMedium{{}, {depth, depth, depth}, 0.0, 1.0}}};
    slab.base = NoBase{};
    const StackWalk stack{slab};
    const AlbedoEstimate result = estimate_albedo(stack, 0.8, {4'000'000, 9, {}});
    const double first_order = depth / (2 * 0.8);
    // Second order: below depth^2 log(1 / depth) / mu.
    EXPECT_NEAR(result.direct.mean[0], first_order,
                kSigmas * result.direct.standard_error[0] + depth * depth * 10);
}

TEST(Medium, PhaseFunctionHasItsMeanCosine) {
    for (const double g : {-0.9, -0.3, 0.0, 0.5, 0.95}) {
        RandomStream random{1, 2};
        Moments cosine;
        constexpr int kCount = 200'000;
        const Vec3 axis = Vec3{0.6, 0.0, 0.8};
        for (int i = 0; i < kCount; ++i) {
            const Vec3 w = sample_phase(axis, g, random);
            cosine.add(w.x * axis.x + w.y * axis.y + w.z * axis.z);
        }
        EXPECT_NEAR(cosine.mean(kCount), g, kSigmas * cosine.standard_error(kCount));
    }
}

TEST(Medium, LosslessScatteringKeepsAllLight) {
    Material slab;
    slab.layers = {{{1.4, Microsurface{Ndf::ggx, {0.2, 0.2}}},
                    ScatteringMedium{{}, {0.5, 1.0, 2.0}, 0.7, 1.0}}};
    slab.base = LambertianBase{{1.0, 1.0, 1.0}};
    const StackWalk stack{slab};
    const AlbedoEstimate result = estimate_albedo(stack, 0.7, {500'000, 10, {}});
    for (std::size_t channel = 0; channel < 3; ++channel)
        EXPECT_NEAR(result.total.mean[channel], 1.0,
                    kSigmas * result.total.standard_error[channel]);
}

TEST(Microsurface, TwoStrataOfMirrorsMatchTheKnownOrders) {
    // d'Eon et al. 2023's benchmark, GGX 0.91 over 0.364 at theta 0.75 and swapped.
    const double known[2][3] = {{0.5610, 0.3132, 0.1010}, {0.6146, 0.2330, 0.1020}};
    const double alphas[2][2] = {{0.91, 0.364}, {0.364, 0.91}};
    const ConductorFacet mirror{{0, 0, 0}, {1e9, 1e9, 1e9}};
    for (int swapped = 0; swapped < 2; ++swapped) {
        Surface surface;
        for (const double alpha : alphas[swapped])
            surface.strata.push_back({0.5, {Ndf::ggx, alpha, alpha}, mirror});
        const SurfaceWalk walk{surface};
        constexpr int kCount = 1'000'000;
        double orders[3] = {0, 0, 0};
        for (int n = 0; n < kCount; ++n) {
            RandomStream random{11, static_cast<std::uint64_t>(n)};
            const Crossing crossing = walk.cross({std::sin(0.75), 0.0, -std::cos(0.75)}, random);
            EXPECT_FALSE(crossing.lost);
            if (crossing.order <= 3) orders[crossing.order - 1] += 1.0 / kCount;
        }
        for (int order = 0; order < 3; ++order) {
            const double error =
                std::hypot(std::sqrt(orders[order] * (1 - orders[order]) / kCount), 2e-4);
            EXPECT_NEAR(orders[order], known[swapped][order], kSigmas * error);
        }
    }
}

TEST(Microsurface, RefusesStrataThatHaveNoCommonBelow) {
    Surface mixed;
    mixed.strata = {{0.5, {Ndf::ggx, 0.1, 0.1}, DielectricFacet{1.5}},
                    {0.5, {Ndf::ggx, 0.1, 0.1}, DiffuseFacet{}}};
    EXPECT_THROW(SurfaceWalk{mixed}, Error);
    EXPECT_THROW(SurfaceWalk{Surface{}}, Error);
}

TEST(Estimator, ResultDependsOnSeedAndCountAlone) {
    const StackWalk stack{over_lambertian({clear_layer(1.5, 0.3)}, 0.5)};
    const AlbedoEstimate once = estimate_albedo(stack, 0.5, {100'000, 1, {}});
    const AlbedoEstimate again = estimate_albedo(stack, 0.5, {100'000, 1, {}});
    const AlbedoEstimate other = estimate_albedo(stack, 0.5, {100'000, 2, {}});
    EXPECT_EQ(once.total.mean[0], again.total.mean[0]);
    EXPECT_NE(once.total.mean[0], other.total.mean[0]);
}

TEST(Estimator, StopsWhenToldAndKeepsWhatIsDone) {
    const StackWalk stack{over_lambertian({clear_layer(1.5, 0.3)}, 0.5)};
    const AlbedoEstimate result = estimate_albedo(
        stack, 0.5, {10'000'000, 1, [](std::uint64_t done) { return done < 200'000; }});
    EXPECT_GE(result.samples, 200'000u);
    EXPECT_LT(result.samples, 1'000'000u);
    EXPECT_GT(result.total.mean[0], 0.0);
}

}  // namespace
}  // namespace lacquer::simulator
