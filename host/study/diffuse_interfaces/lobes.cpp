// Figure 11: where the light from the base goes.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "study/coat_light.h"
#include "study/diffuse_interfaces/materials.h"
#include "study/diffuse_interfaces/suite.h"
#include "study/material_pictures.h"

namespace lacquer::study {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kBins = 32;        // of equal cos_theta_i
constexpr int kRingsPerBin = 2;  // dots of the curves
constexpr int kSteps = 32;       // of the models' light, per ring
constexpr double kAlbedo = 0.5;
constexpr glm::dvec3 kNormal{0.0, 0.0, 1.0};

struct LobeCase {
    double eta, alpha, tau;
};

// Smooth to rough, below and above 1.
constexpr LobeCase kCases[] = {{0.6, 0.05, 1.0}, {0.6, 0.3, 1.0},  {0.8, 0.05, 1.0},
                               {0.8, 0.3, 1.0},  {0.9, 0.05, 1.0}, {0.9, 0.05, 0.3},
                               {1.5, 0.05, 1.0}, {1.5, 0.3, 0.3},  {2.0, 0.6, 0.3}};

// Shares of the light in rings of equal cos_theta_i.
struct Lobe {
    std::vector<double> shares, errors{};
};

constexpr int kLobeRings = kBins * kRingsPerBin;

Lobe simulated_lobe(const Material& material, const StudyRun& run) {
    const BaseLight light = simulate_base_light(simulator::StackWalk{material}, 1.0, kLobeRings,
                                                run.options(run.share(2), "lobe " + material.name));
    Lobe lobe;
    for (const simulator::RgbEstimate& ring : light.rings) {
        lobe.shares.push_back(ring.mean[0] / light.base.mean[0]);
        lobe.errors.push_back(ring.standard_error[0] / light.base.mean[0]);
    }
    return lobe;
}

Lobe model_lobe(const ModelLight& model) {
    Lobe lobe{std::vector<double>(kLobeRings, 0.0)};
    double all = 0.0;
    for (int step = 0; step < kLobeRings * kSteps; ++step) {
        const double z = (step + 0.5) / (kLobeRings * kSteps);
        const glm::dvec3 wi{std::sqrt(1.0 - z * z), 0.0, z};
        const double light = model.base(wi, kNormal).x * z;
        lobe.shares[static_cast<std::size_t>(step / kSteps)] += light;
        all += light;
    }
    if (all > 0.0)
        for (double& share : lobe.shares) share /= all;
    return lobe;
}

// Shares of a ring per solid angle, over theta_i.
Curve density_curve(const std::string& label, const Lobe& lobe) {
    Curve curve{label};
    const double per_solid_angle = kLobeRings / (2.0 * kPi);
    for (std::size_t ring = lobe.shares.size(); ring-- > 0;) {
        const double cos_theta = (static_cast<double>(ring) + 0.5) / kLobeRings;
        curve.x.push_back(std::acos(cos_theta) * 180.0 / kPi);
        curve.y.push_back(per_solid_angle * lobe.shares[ring]);
        if (!lobe.errors.empty()) curve.errors.push_back(per_solid_angle * lobe.errors[ring]);
    }
    return curve;
}

// Total variation over kBins.
ModelError distance(const Lobe& model, const Lobe& truth, const std::string& subject,
                    const std::string& name) {
    ModelError error{subject, name};
    for (int bin = 0; bin < kBins; ++bin) {
        double difference = 0.0, variance = 0.0;
        for (int ring = bin * kRingsPerBin; ring < (bin + 1) * kRingsPerBin; ++ring) {
            const auto index = static_cast<std::size_t>(ring);
            difference += model.shares[index] - truth.shares[index];
            variance += truth.errors[index] * truth.errors[index];
        }
        error.mean += 0.5 * std::abs(difference);
        error.noise += 0.5 * std::sqrt(2.0 / kPi * variance);
        if (std::abs(difference) < error.max) continue;
        error.max = std::abs(difference);
        error.where =
            fmt::format("cos_theta {:.3g} to {:.3g}", double(bin) / kBins, double(bin + 1) / kBins);
    }
    return error;
}

Plot lobe_plot(const LobeCase& at, const StudyRun& run, Figure& figure) {
    const Rgb tau{at.tau, at.tau, at.tau}, albedo{kAlbedo, kAlbedo, kAlbedo};
    const Material material = coated(at.eta, at.alpha, albedo, tau);
    const std::string title = fmt::format("eta {}, alpha {}, tau {}", at.eta, at.alpha, at.tau);
    run.part("lobe, " + title);
    const Lobe truth = simulated_lobe(material, run);
    Plot plot{title, "theta_i, degrees", "density", 0.0, 90.0, 0.0, 0.0};
    plot.curves.push_back(density_curve("simulation", truth));
    plot.curves.back().dots = true;
    for (const ModelLight& model : models_of(material, compared_models())) {
        const Lobe lobe = model_lobe(model);
        figure.errors.push_back(distance(lobe, truth, title, model.name()));
        const bool is_shown = model.name().starts_with("coated") || model.name() == "plain";
        if (is_shown) plot.curves.push_back(density_curve(model.name(), lobe));
    }
    for (const Curve& curve : plot.curves)
        plot.y_to = std::max(plot.y_to, 1.02 * *std::ranges::max_element(curve.y));
    return plot;
}

}  // namespace

Figure lobes_figure(const StudyRun& run) {
    Figure figure{
        "figure-11", "Figure 11: the lobe of the base's light",
        "The light that comes back from the base, per solid angle and cosine, all of it 1, seen "
        "along the normal. Below eta 1 it ends at the critical angle, sharply where the coat is "
        "smooth: a GGX lobe of the same variance (coated-ggx) has no such edge, peaks in the "
        "middle "
        "and has a tail, so that it is some 0.3 off; from eta 1 on it is near. coated-exact has "
        "the "
        "edge, since by reciprocity light leaves as it enters. The base of plain is a Lambertian "
        "lobe.",
        "total variation distance of the base's light from the simulated, in 32 bins of equal "
        "cos_theta; max is the largest difference of one bin"};
    Plots plots;
    for (const LobeCase& at : kCases) plots.plots.push_back(lobe_plot(at, run, figure));
    figure.panels.emplace_back(std::move(plots));
    return figure;
}

}  // namespace lacquer::study
