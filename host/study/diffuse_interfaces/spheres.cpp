// Figures 4, 7, 8 and 9: materials as spheres and slices.
#include <fmt/format.h>

#include <array>

#include "core/paths.h"
#include "study/coat_light.h"
#include "study/diffuse_interfaces/abscissa.h"
#include "study/diffuse_interfaces/albedo_plot.h"
#include "study/diffuse_interfaces/materials.h"
#include "study/diffuse_interfaces/suite.h"
#include "study/material_pictures.h"
#include "tables/energy_tables.h"

namespace lacquer::study {

namespace {

constexpr double kSliceAngle_deg = 45.0;
constexpr std::array kChannels{"red", "green", "blue"};
constexpr std::array kChannelColors{"#d4573f", "#3ba35a", "#3a86c8"};

constexpr const char* kMeasure =
    "mean |difference| of the pixels over their mean; max is the largest of a pixel, in radiance, "
    "beyond three standard errors of the simulation";

void add_coated(Figure& figure, const Material& material, const StudyRun& run,
                std::span<const Model> models = compared_models()) {
    const std::array views{sphere_view(), slice_view(kSliceAngle_deg)};
    std::vector<Radiance> truth;
    for (const View& view : views) truth.push_back(simulate(view, material, run));
    add_material(figure, material, views, truth, models_of(material, models));
}

// The albedo that gives the base under the same coat, but clear, the light that `material` has at
// this angle: eq. 3 solved for rho.
Rgb matching_albedo(const Material& material, double cos_theta) {
    const EnergyTables tables{share_folder() / "tables"};
    const Layer& layer = material.layers.front();
    const double eta = layer.interface.ior;
    const double alpha = std::get<Microsurface>(layer.interface.roughness).alpha[0];
    const Rgb& tau = std::get<AbsorbingMedium>(layer.medium).tau;
    const Rgb& rho = std::get<LambertianBase>(material.base).albedo;
    Rgb matching;
    for (std::size_t c = 0; c < 3; ++c) {
        const double light = tables.t_down(cos_theta, alpha, eta, tau[c]) * rho[c] *
                             tables.t_up(alpha, eta, tau[c]) /
                             (1.0 - rho[c] * tables.r_up(alpha, eta, tau[c]));
        matching[c] =
            light / (tables.t_down(cos_theta, alpha, eta, 1.0) * tables.t_up(alpha, eta, 1.0) +
                     light * tables.r_up(alpha, eta, 1.0));
    }
    return matching;
}

// Red, green and blue of both over the viewer's angle, simulated and by coated-exact.
Plots hue_plots(const Material& tinted, const Material& clear, const StudyRun& run) {
    Plots plots{"Colour over the viewer's angle: all that comes back", {}};
    for (const Material* material : {&tinted, &clear}) {
        Plot plot = empty_plot(material->name, kCosine, "albedo", 1.0);
        const ModelLight model{*material, Model::coated_exact};
        for (int channel = 0; channel < 3; ++channel) {
            const AlbedoPlot part{"", Light::total, channel};
            Curve curve = model_albedo(part, model), dots = simulated_albedo(part, *material, run);
            curve.label = kChannels[static_cast<std::size_t>(channel)];
            curve.color = dots.color = kChannelColors[static_cast<std::size_t>(channel)];
            dots.label.clear();
            plot.curves.push_back(std::move(curve));
            plot.curves.push_back(std::move(dots));
        }
        plots.plots.push_back(std::move(plot));
    }
    return plots;
}

}  // namespace

Figure spheres_figure(const StudyRun& run) {
    Figure figure{
        "figure-4", "Figure 4: the model beside the simulation",
        "A sphere under one light and a dim uniform sky, and the light from all directions that a "
        "viewer at 45 degrees sees (equal-area, the highlight left of the middle). Below eta 1 "
        "light enters only within the critical angle, which draws the edges across sphere and "
        "slice; coated-ggx cannot follow them. What coated-exact lacks at eta 0.8 is light that "
        "met several facets of the coat: it leaves near the mirror direction, and the model "
        "spreads "
        "it evenly.",
        kMeasure};
    add_coated(figure, coated(0.8, 0.1, {0.2, 1.0, 0.2}), run);
    add_coated(figure, coated(1.2, 0.1, {1.0, 0.1, 0.1}), run);
    return figure;
}

Figure validation_figure(const StudyRun& run) {
    Figure figure{
        "figure-7", "Figure 7: thin and dense coats, smooth to rough",
        "A red base under other coats; those below eta 1 are the left column of the paper. The "
        "inner "
        "disk is light that reached the base, what surrounds it the coat's reflection. The coat of "
        "eta 0.8 and alpha 0.4 is the hardest case: most of its light has met several facets, "
        "going "
        "in and out of them, and leaves forwards, where the models put none or spread it evenly; "
        "the simulation's grains are the few walks that carry much of that light.",
        kMeasure};
    const Rgb red{1.0, 0.1, 0.1};
    for (const auto& [eta, alpha] :
         {std::pair{0.6, 0.05}, {0.8, 0.05}, {0.8, 0.4}, {1.5, 0.05}, {2.0, 0.5}})
        add_coated(figure, coated(eta, alpha, red), run);
    return figure;
}

Figure multiple_scattering_figure(const StudyRun& run) {
    Figure figure{
        "figure-8", "Figure 8: light that goes back and forth below the coat",
        "Weidlich and Wilkie let light cross the coat once each way. What the coat sends back down "
        "to the base, six tenths of it at eta 1.5, is lost to them, and with it the colour's "
        "depth: "
        "each return multiplies by the base's albedo once more. Their sphere is no darker for it, "
        "because they also leave out that refraction spreads the light that leaves over eta "
        "squared "
        "times the solid angle. openpbr-coat has the depth, and loses light at grazing angles.",
        kMeasure};
    const Rgb base{0.95, 0.55, 0.2};
    const Material material = coated(1.5, 0.3, base);
    add_coated(figure, material, run);
    const auto models = models_of(material, compared_models());
    Plots plots{"Albedo over the viewer's angle", {}};
    for (int channel = 0; channel < 3; ++channel) {
        const auto index = static_cast<std::size_t>(channel);
        const std::string title =
            fmt::format("{}, albedo of the base {}", kChannels[index], base[index]);
        plots.plots.push_back(
            albedo_plot({title, Light::total, channel, 1.2}, material, models, {}, run));
    }
    figure.panels.emplace_back(std::move(plots));
    return figure;
}

Figure absorption_figure(const StudyRun& run) {
    constexpr double kMatched = 0.1;
    Figure figure{
        "figure-9", "Figure 9: absorption changes the hue towards the edges",
        "Paths through the coat are longer at grazing angles, so that a medium that absorbs tints "
        "the edges more than the middle. The second material has a clear medium, and the albedo "
        "that "
        "matches the first at cos_theta 0.1: with an albedo alone the middle is as deep as the "
        "edge. "
        "clearcoat and plain know no absorption, openpbr-coat and weidlich-wilkie too little of "
        "it: "
        "light that goes back and forth crosses the medium more than twice.",
        kMeasure};
    const Material tinted = coated(1.3, 0.1, {0.95, 0.95, 0.95}, {0.97, 0.75, 0.45});
    add_coated(figure, tinted, run);
    Material clear = coated(1.3, 0.1, matching_albedo(tinted, kMatched));
    clear.name = "albedo only";
    add_coated(figure, clear, run);
    figure.panels.emplace_back(hue_plots(tinted, clear, run));
    return figure;
}

}  // namespace lacquer::study
