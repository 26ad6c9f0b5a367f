// The light that the model `stack` lets through where it has no base: closed forms of smooth
// stacks, and what it promises of its functions below the surface.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

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

Material without_base(std::vector<Layer> layers) {
    Material material;
    material.layers = std::move(layers);
    material.base = NoBase{};
    return material;
}

double transmitted(const Material& material, double cos_theta) {
    return reference::albedo(prepare_stack(material, tables()), direction(cos_theta)).transmitted.x;
}

// Of smooth interfaces and the media below them, from the bottom up: each lets
// (1 - r) tau T / (1 - r R tau^2) through, where what lies below reflects R and lets T through.
double smooth_transmittance(const Material& material, double cos_theta) {
    double ior = 1.0;
    std::vector<double> eta, cosine{cos_theta};
    for (const Layer& at : material.layers) {
        eta.push_back(at.interface.ior / ior);
        ior = at.interface.ior;
        cosine.push_back(std::sqrt(1.0 - (1.0 - cos_theta * cos_theta) / (ior * ior)));
    }
    double reflected = 0.0, through = 1.0;
    for (std::size_t n = material.layers.size(); n-- > 0;) {
        const double tau = std::pow(std::get<AbsorbingMedium>(material.layers[n].medium).tau[0],
                                    1.0 / cosine[n + 1]);
        const double r = test::smooth_reflectance(cosine[n], eta[n]);
        const double seen = reflected * tau * tau;
        through *= (1.0 - r) * tau / (1.0 - r * seen);
        reflected = r + (1.0 - r) * (1.0 - r) * seen / (1.0 - r * seen);
    }
    return through;
}

// That smooth stacks of any number of layers let through what the Fresnel equations, absorption
// and a geometric series per layer say.
TEST(StackTransmission, SmoothStacksAreExact) {
    constexpr double kExact = 1e-4;
    const std::vector<Layer> layers{layer(1.5, 0.0, 0.9), layer(2.0, 0.0, 0.6),
                                    layer(1.2, 0.0, 1.0), layer(1.0, 0.0, 0.8)};
    for (std::size_t count = 1; count <= layers.size(); ++count) {
        const Material material =
            without_base({layers.begin(), layers.begin() + static_cast<long>(count)});
        for (const double cos_theta : {0.05, 0.2, 0.5, 0.8, 1.0})
            EXPECT_NEAR(transmitted(material, cos_theta), smooth_transmittance(material, cos_theta),
                        kExact)
                << count << " layers, cos " << cos_theta;
    }
}

// That clear stacks reflect what they do not let through.
TEST(StackTransmission, ClearStacksLoseNothing) {
    constexpr double kFurnace = 0.003;
    for (const double alpha : {0.0, 0.01, 0.1, 0.3, 0.6, 0.8})
        for (const double cos_theta : {0.1, 0.4, 0.7, 1.0}) {
            const Material material = without_base(
                {layer(1.5, alpha, 1.0), layer(1.2, 0.5 * alpha, 1.0), layer(1.0, alpha, 1.0)});
            const reference::Albedo albedo =
                reference::albedo(prepare_stack(material, tables()), direction(cos_theta));
            EXPECT_NEAR(albedo.direct.x + albedo.base.x + albedo.transmitted.x, 1.0, kFurnace)
                << "alpha " << alpha << ", cos " << cos_theta;
        }
}

// A stack as one viewer sees it, who points to the surface.
struct Looked {
    explicit Looked(const Material& material, const glm::dvec3& wo)
        : surface{prepare_stack(material, tables())}, seen{reference::view(surface, wo)} {}
    Looked(const Looked&) = delete;
    Looked& operator=(const Looked&) = delete;

    reference::StackSurface surface;
    reference::StackView seen;
};

const Material& rough_plate() {
    static const Material plate = without_base({layer(1.5, 0.4, 0.9), layer(1.0, 0.3, 1.0)});
    return plate;
}

// The integral of f |cos| over the lower hemisphere, by midpoints in the cosine and the azimuth.
double integral_below(const reference::StackView& seen) {
    constexpr int kSteps = 400;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i)
        for (int j = 0; j < kSteps; ++j) {
            const double z = (i + 0.5) / kSteps, phi = 2 * std::numbers::pi * (j + 0.5) / kSteps;
            const double radius = std::sqrt(1.0 - z * z);
            sum +=
                z * reference::eval(seen, {radius * std::cos(phi), radius * std::sin(phi), -z}).x;
        }
    return sum * 2 * std::numbers::pi / (kSteps * kSteps);
}

// That the lobes' integral is the transmitted energy, as far as midpoints and the table of what
// single reflections have of light know (measured: 0.0023).
TEST(StackTransmission, LobesIntegrateToTheirEnergy) {
    constexpr double kIntegral = 4e-3;
    for (const double cos_theta : {0.15, 0.5, 1.0})
        for (const double ior : {1.0, 1.2}) {
            const Looked plate{without_base({layer(1.5, 0.4, 0.9), layer(ior, 0.3, 0.8)}),
                               direction(cos_theta)};
            EXPECT_NEAR(integral_below(plate.seen),
                        reference::albedo(plate.surface, plate.seen.wo).transmitted.x, kIntegral)
                << "cos " << cos_theta << ", ior " << ior;
        }
}

// That lobes lie where light goes on: a smooth plate's mean is opposite to the viewer, in every
// azimuth.
TEST(StackTransmission, SmoothPlatesDoNotBendLight) {
    const Material window = without_base({layer(1.5, 0.0, 1.0), layer(1.0, 0.0, 1.0)});
    for (const double phi : {0.0, 1.0, 2.5, 4.0}) {
        const glm::dvec3 wo{0.8 * std::cos(phi), 0.8 * std::sin(phi), 0.6};
        const Looked plate{window, wo};
        for (const reference::TransmissionLobe& lobe : plate.seen.transmission)
            EXPECT_LE(glm::length(lobe.from - wo), 1e-9) << "phi " << phi;
        EXPECT_GT(reference::eval(plate.seen, -wo).x, 1e3) << "phi " << phi;
    }
}

// That `sample` draws from `pdf` on both sides.
TEST(StackTransmission, SamplesFitTheirDensity) {
    const Looked plate{rough_plate(), {0.48, 0.64, 0.6}};
    const test::Sampler sampler = [&](const glm::dvec3& u) -> std::optional<glm::dvec3> {
        const reference::Sample sample = reference::sample(plate.seen, u);
        if (sample.pdf <= 0.0) return std::nullopt;
        return sample.wi;
    };
    test::expect_sphere_sampling_fit(
        sampler, [&](const glm::dvec3& wi) { return reference::pdf(plate.seen, wi); }, 1e-3,
        "a rough plate");
}

// That weights average to all light that is reflected and let through, in as far as the lobes of
// reflections integrate to theirs (coat.h: 0.005 in the mean).
TEST(StackTransmission, WeightsAverageToTheAlbedo) {
    constexpr int kSamples = 400'000;
    constexpr double kNoise = 5.0, kLobes = 0.006;
    const Looked plate{rough_plate(), {0.48, 0.64, 0.6}};
    std::mt19937_64 generator{5};
    std::uniform_real_distribution<double> uniform;
    double sum = 0.0, squares = 0.0;
    for (int n = 0; n < kSamples; ++n) {
        const glm::dvec3 u{uniform(generator), uniform(generator), uniform(generator)};
        const double weight = reference::sample(plate.seen, u).weight.x;
        sum += weight;
        squares += weight * weight;
    }
    const double mean = sum / kSamples;
    const double error = std::sqrt((squares / kSamples - mean * mean) / kSamples);
    const reference::Albedo albedo = reference::albedo(plate.surface, plate.seen.wo);
    EXPECT_NEAR(mean, albedo.direct.x + albedo.transmitted.x, kNoise * error + kLobes);
}

// That nothing comes from below where a base is, nor to a viewer below.
TEST(StackTransmission, OnlyThroughStacksWithoutBase) {
    const glm::dvec3 wo = direction(0.6), below{0.3, 0.4, -std::sqrt(0.75)};
    Material material = rough_plate();
    const auto plate = prepare_stack(material, tables());
    EXPECT_GT(reference::eval(plate, below, wo).x, 0.0);
    EXPECT_GT(reference::pdf(plate, below, wo), 0.0);
    EXPECT_EQ(reference::eval(plate, wo, below), glm::dvec3{0.0});
    EXPECT_EQ(reference::pdf(plate, wo, below), 0.0);
    EXPECT_EQ(reference::sample(plate, below, {0.5, 0.5, 0.5}).pdf, 0.0);
    const Base bases[] = {
        LambertianBase{{0.5, 0.5, 0.5}},
        ConductorBase{{0.2, 0.2, 0.2}, {3, 3, 3}, Microsurface{Ndf::ggx, {0.3, 0.3}}}};
    for (const Base& base : bases) {
        material.base = base;
        const auto surface = prepare_stack(material, tables());
        EXPECT_EQ(reference::eval(surface, below, wo), glm::dvec3{0.0});
        EXPECT_EQ(reference::pdf(surface, below, wo), 0.0);
        EXPECT_EQ(reference::albedo(surface, wo).transmitted, glm::dvec3{0.0});
        for (double choice = 0.01; choice < 1.0; choice += 0.02) {
            const auto sample = reference::sample(surface, wo, {choice, 0.4, 0.6});
            EXPECT_TRUE(sample.wi.z > 0.0 || sample.pdf == 0.0) << choice;
        }
    }
}

}  // namespace
}  // namespace lacquer
