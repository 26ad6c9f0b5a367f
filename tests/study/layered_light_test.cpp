// The simulated light of the suite `layered` and what it asks of models, against closed forms.
#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "study/layered/ball.h"
#include "study/layered/compared.h"
#include "study/layered/counted_slice.h"
#include "study/layered/light_statistics.h"
#include "study/layered/stacks.h"

namespace lacquer::study {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kRounding = 1e-9;
constexpr double kSigmas = 4.5;  // of some tens of numbers: two-sided 2e-4 with Sidak's correction
constexpr std::uint64_t kWalks = 1 << 16;

// Returns all light, index 10 i.
Material bare_mirror() {
    return stack_of("mirror", {}, grey_conductor(0.0, 10.0, 0.0));
}

Material matte(double albedo) {
    return stack_of("matte", {}, LambertianBase{{albedo, albedo, albedo}});
}

StudyRun run_of(std::uint64_t walks) {
    StudyRun run;
    run.samples = walks;
    return run;
}

const glm::dvec3 kCamera{0.0, 0.0, 1.0};
const std::array kNormals{glm::normalize(glm::dvec3{-0.3, 0.35, 0.9}), kCamera,
                          glm::normalize(glm::dvec3{0.4, -0.5, 0.2})};

Radiance simulated(const Material& material, const glm::dvec3& normal, Surroundings surroundings) {
    const simulator::StackWalk stack{material};
    const glm::dvec3 wo = local_viewer(normal, kCamera);
    return received(std::array{frame_towards(normal, kCamera)}, surroundings, kWalks,
                    [&](std::uint64_t n) { return walked(stack, wo, 7, n); });
}

TEST(LayeredLight, AMirrorShowsWhatIsInTheMirrorDirection) {
    for (const glm::dvec3& normal : kNormals) {
        const glm::dvec3 mirrored = 2.0 * glm::dot(normal, kCamera) * normal - kCamera;
        EXPECT_NEAR(simulated(bare_mirror(), normal, studio).values[0].y, studio(mirrored),
                    kRounding);
    }
}

TEST(LayeredLight, AMatteSurfaceShowsItsIrradiance) {
    constexpr int kSteps = 1000;         // of either angle
    constexpr double kMidpoints = 2e-4;  // their error, over edges of 20 steps
    for (const glm::dvec3& normal : kNormals) {
        const Frame frame = frame_towards(normal, kCamera);
        double irradiance = 0.0;
        for (int n = 0; n < kSteps * kSteps; ++n) {
            const double sin2 = (n / kSteps + 0.5) / kSteps;
            const double phi = 2.0 * std::numbers::pi * (n % kSteps + 0.5) / kSteps;
            const double sine = std::sqrt(sin2);
            irradiance += studio(sine * std::cos(phi) * frame.x + sine * std::sin(phi) * frame.y +
                                 std::sqrt(1.0 - sin2) * frame.z);
        }
        irradiance /= kSteps * kSteps;
        const Radiance radiance = simulated(matte(0.5), normal, studio);
        EXPECT_NEAR(radiance.values[0].x, 0.5 * irradiance,
                    kMidpoints + kSigmas * radiance.errors[0].x);
        const Radiance all = simulated(matte(0.5), normal, white_furnace);
        EXPECT_NEAR(all.values[0].x, 0.5, kRounding);
    }
}

TEST(LayeredLight, BallsOfModelAndSimulationAgreeWhereTheModelIsExact) {
    constexpr double kEvenPoints = 0.02;  // error of 512 points times 16 pixels
    const View view = ball_view();
    const Material material = matte(0.8);
    const Radiance truth =
        simulate_ball(view, simulator::StackWalk{material}, studio, run_of(1 << 20), "matte");
    const Radiance shaded = shade_ball(view, ModelLight{material, Model::plain}, studio, 512);
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.values.size(); ++i) {
        EXPECT_NEAR(shaded.values[i].x, truth.values[i].x,
                    kEvenPoints + kSigmas * truth.errors[i].x);
        sum += shaded.values[i].x - truth.values[i].x;
    }
    EXPECT_NEAR(sum / static_cast<double>(truth.values.size()), 0.0, 0.1 * kEvenPoints);
}

TEST(LayeredLight, HalvesOfAModelsSamplesTellItsError) {
    constexpr double kEvenPoints = 0.02;
    const ModelLight model{matte(0.8), Model::plain};
    const glm::dvec3 normal = kNormals[0], wo = local_viewer(normal, kCamera);
    const std::array frames{frame_towards(normal, kCamera)};
    const auto emit = [&](std::uint64_t n) { return sampled(model, wo, n); };
    const Radiance white = received_evenly(frames, white_furnace, 512, emit);
    EXPECT_NEAR(white.values[0].x, 0.8, kRounding);
    EXPECT_NEAR(white.errors[0].x, 0.0, kRounding);
    const Radiance room = received_evenly(frames, studio, 512, emit);
    EXPECT_GT(room.errors[0].x, 0.0);
    EXPECT_LT(room.errors[0].x, kEvenPoints);
    EXPECT_NEAR(room.values[0].x, received(frames, studio, 512, emit).values[0].x, kRounding);
}

TEST(LayeredLight, AMatteSliceIsTheCosine) {
    const View view = slice_view(30.0);
    const Material material = matte(0.5);
    const Radiance shaded = shade_pixels(view, ModelLight{material, Model::plain});
    const Radiance truth = simulate_counted_slice(view, material, run_of(kWalks));
    double sum = 0.0, all = 0.0;
    for (std::size_t i = 0; i < shaded.values.size(); ++i) {
        const double cosine = query_of(view.grid, i).wi.z;
        EXPECT_NEAR(shaded.values[i].x, 0.5 * cosine, 1e-6);
        sum += truth.values[i].x;
        all += 0.5 * cosine;
    }
    EXPECT_NEAR(sum / all, 1.0, 0.02);  // four standard errors of so many walks, and the rim
}

TEST(LayeredLight, StatisticsOfAMatteSurface) {
    const LightStatistics truth =
        simulate_statistics(matte(0.6), 0.4, kWalks, run_of(kWalks), "matte");
    EXPECT_NEAR(truth.all.energy, 0.6, kRounding);
    EXPECT_NEAR(truth.base.energy, 0.6, kRounding);
    EXPECT_NEAR(truth.base.width, 0.5, kSigmas * truth.base.width_error);
    // Of (r^2 / 2), uniform on [0, 1/2], over twice the width 1/2.
    const double error = std::sqrt(1.0 / 48.0 / kWalks);
    EXPECT_NEAR(truth.base.width_error, error, 0.05 * error);
    const LightStatistics model = model_statistics(ModelLight{matte(0.6), Model::plain}, 0.4);
    EXPECT_NEAR(model.base.energy, 0.6, kRounding);
    EXPECT_NEAR(model.base.width, 0.5, 0.005);
}

TEST(LayeredLight, WidthsOfAMirrorAreNone) {
    EXPECT_NEAR(simulate_statistics(bare_mirror(), 0.5, 64, run_of(64), "mirror").all.width, 0.0,
                1e-6);
}

TEST(Compared, SaysWhyAModelCannotShade) {
    const Material two = stack_of("two", {coat(1.5, 0.1), coat(1.3, 0.1)}, metal("gold", 0.2));
    for (const Compared& model : compared_on(two)) {
        const bool shades_one = model.name == "weidlich-wilkie" || model.name == "clearcoat";
        EXPECT_EQ(model.light.has_value(), !shades_one) << model.name;
        EXPECT_EQ(model.why_not.empty(), !shades_one) << model.name;
        if (shades_one) {
            EXPECT_THAT(model.why_not, HasSubstr("/layers/1"));
        }
    }
    EXPECT_EQ(lights_of(compared_on(two)).size(), 2u);
    for (const Compared& model :
         compared_on(stack_of("film", {scattering_film(1.0, 0.7)}, matte(1.0).base)))
        EXPECT_NE(model.light.has_value(), !model.why_not.empty()) << model.name;
}

// All light less that of a black base is the base's.
TEST(Compared, StackKnowsTheBasesLight) {
    const Material material = stack_of("coat", {coat(1.5, 0.2)}, metal("gold", 0.2));
    const ModelLight stack = *compared_on(material, Need::base).front().light;
    const LightStatistics statistics = model_statistics(stack, 0.7);
    const auto albedo = stack.albedo({std::sqrt(1.0 - 0.49), 0.0, 0.7});
    EXPECT_GT(albedo.direct.x, 0.0);
    EXPECT_NEAR(statistics.all.energy - statistics.base.energy,
                (albedo.direct.x + albedo.direct.y + albedo.direct.z) / 3.0, kRounding);
    EXPECT_GT(statistics.base.width, 0.0);
    EXPECT_THROW(metal("unobtainium", 0.1), std::exception);
}

}  // namespace
}  // namespace lacquer::study
