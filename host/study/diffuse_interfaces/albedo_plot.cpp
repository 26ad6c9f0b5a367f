#include "study/diffuse_interfaces/albedo_plot.h"

#include <fmt/format.h>

#include "simulator/albedo.h"
#include "study/diffuse_interfaces/abscissa.h"

namespace lacquer::study {

namespace {

constexpr std::uint64_t kDotShare = 1 << 5;

double albedo_at(const AlbedoPlot& plot, const ModelLight& model, double cos_theta) {
    const auto albedo = model.albedo({std::sqrt(1.0 - cos_theta * cos_theta), 0.0, cos_theta});
    const double base = albedo.base[plot.channel];
    return plot.light == Light::base ? base : base + albedo.direct[plot.channel];
}

}  // namespace

Curve simulated_albedo(const AlbedoPlot& plot, const Material& material, const StudyRun& run) {
    const simulator::StackWalk stack{material};
    Curve curve{"simulation", dot_positions(kCosine)};
    curve.dots = true;
    for (const double cosine : curve.x) {
        const auto albedo = simulator::estimate_albedo(
            stack, cosine,
            run.options(run.share(kDotShare), fmt::format("albedo {} {}", material.name, cosine)));
        const auto& light = plot.light == Light::base ? albedo.base : albedo.total;
        curve.y.push_back(light.mean[static_cast<std::size_t>(plot.channel)]);
        curve.errors.push_back(light.standard_error[static_cast<std::size_t>(plot.channel)]);
    }
    return curve;
}

Curve model_albedo(const AlbedoPlot& plot, const ModelLight& model) {
    return line(model.name(), kCosine,
                [&](double cosine) { return albedo_at(plot, model, cosine); });
}

Plot albedo_plot(const AlbedoPlot& plot, const Material& material,
                 std::span<const ModelLight> models, std::span<ErrorTally> tallies,
                 const StudyRun& run) {
    Plot result = empty_plot(plot.title, kCosine, "albedo", plot.top);
    const Curve truth = simulated_albedo(plot, material, run);
    result.curves.push_back(truth);
    for (std::size_t m = 0; m < models.size(); ++m) {
        result.curves.push_back(model_albedo(plot, models[m]));
        if (tallies.empty()) continue;
        for (std::size_t n = 0; n < truth.x.size(); ++n)
            tallies[m].add(
                albedo_at(plot, models[m], truth.x[n]) - truth.y[n], truth.errors[n],
                [&] { return fmt::format("{}, cos_theta {:.3g}", material.name, truth.x[n]); });
    }
    return result;
}

}  // namespace lacquer::study
