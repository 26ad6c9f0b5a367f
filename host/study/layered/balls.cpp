// Figures 11, 13, 14, 17 and 22 of 2018 and 10 of 2022, and the bundled materials, as balls.
#include <fmt/format.h>

#include <array>

#include "core/paths.h"
#include "simulator/albedo.h"
#include "study/diffuse_interfaces/abscissa.h"
#include "study/diffuse_interfaces/albedo_plot.h"
#include "study/layered/ball.h"
#include "study/layered/stack_pictures.h"
#include "study/layered/stacks.h"
#include "study/layered/statistics_plot.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

constexpr std::array kChannels{"red", "green", "blue"};
constexpr double kTopAlbedo = 1.1;
constexpr std::uint64_t kDotShare = 1 << 5;

std::vector<Shown> shown_balls(std::span<const Material> materials, const StudyRun& run) {
    std::vector<Shown> shown;
    for (const Material& material : materials) shown.push_back(shown_ball(material, run));
    return shown;
}

// Red, green and blue over the viewer's angle, simulated once for all three.
Plots albedo_plots(const Material& material, const StudyRun& run) {
    const std::vector<ModelLight> models = lights_of(compared_on(material));
    const simulator::StackWalk stack{material};
    Curve dots{"simulation", dot_positions(kCosine)};
    dots.dots = true;
    std::array<Curve, 3> truth{dots, dots, dots};
    for (const double cosine : dots.x) {
        const auto albedo = simulator::estimate_albedo(
            stack, cosine,
            run.options(run.share(kDotShare), fmt::format("albedo {} {}", material.name, cosine)));
        for (std::size_t c = 0; c < truth.size(); ++c) {
            truth[c].y.push_back(albedo.total.mean[c]);
            truth[c].errors.push_back(albedo.total.standard_error[c]);
        }
    }
    Plots plots{"Albedo over the viewer's angle", {}};
    for (int channel = 0; channel < 3; ++channel) {
        const auto c = static_cast<std::size_t>(channel);
        Plot plot = empty_plot(kChannels[c], kCosine, "albedo", kTopAlbedo);
        plot.curves.push_back(truth[c]);
        for (const ModelLight& model : models)
            plot.curves.push_back(
                model_albedo({kChannels[c], Light::total, channel, kTopAlbedo}, model));
        plots.plots.push_back(std::move(plot));
    }
    return plots;
}

constexpr Abscissa kThickness{"thickness", 0.1, 4.0, true};

Material filmed_gold(double thickness) {
    constexpr double kForward = 0.7;
    return stack_of(fmt::format("thickness {}", thickness), {scattering_film(thickness, kForward)},
                    metal("gold", 0.05));
}

// The bundled materials that have more than a model of one layer over a base knows.
constexpr std::array kBundled{"two_tone_car_paint",   "frosted_metal",     "anodised_aluminium",
                              "brushed_coated_steel", "wet_clay",          "pearl_over_gold",
                              "five_layer_furnace",   "clear_glass_plate", "tinted_glass",
                              "varnished_wood"};

}  // namespace

Figure saturation_figure(const StudyRun& run) {
    // In, off the base and out again, one facet each.
    constexpr int kOneReflection = 3;
    Figure figure{
        "figure-11", "Figure 11: light between the interfaces deepens the colour",
        "Copper under a rough coat of index 2. The last column simulates only light that meets "
        "one facet at each interface it reaches, in and off the metal and out: it is darker, and "
        "paler, for what the coat sends back down meets the metal again and takes its colour once "
        "more. stack has that light. weidlich-wilkie, clearcoat and plain let the copper shine "
        "through as if the coat sent nothing back.",
        kPictureMeasure};
    const Material material =
        stack_of("copper under index 2, alpha 0.3", {coat(2.0, 0.3)}, metal("copper", 0.3));
    const std::array shown{shown_ball(material, run)};
    add_pictures(figure, "In the studio", shown);
    const simulator::StackWalk single{material, {1}};
    const std::array once{
        simulate_ball(shown[0].view, single, studio, run, material.name + " once", kOneReflection)};
    add_column(figure, "one reflection per layer, simulated", shown, once);
    figure.panels.emplace_back(albedo_plots(material, run));
    return figure;
}

Figure frosted_metal_figure(const StudyRun& run) {
    Figure figure{
        "figure-13", "Figure 13: frosted metal",
        "A rough coat of index 1.5 over polished gold. What the gold mirrors has crossed the "
        "rough coat twice: at alpha 0.1 the panes of the window run together, at 0.3 only a glow "
        "is left. weidlich-wilkie, clearcoat and plain keep the gold a mirror, whose reflection "
        "is sharp, and whose light lies in one pixel of the slice. stack widens the lobe of the "
        "gold to that of the simulation, but a GGX lobe has a longer tail: in the slices it is "
        "too bright towards the normal and too dark at its peak, and it lacks the faint light "
        "near the horizon that went back and forth and took on the gold's colour again.",
        kPictureMeasure};
    std::vector<Material> materials;
    for (const double alpha : {0.1, 0.3})
        materials.push_back(stack_of(fmt::format("alpha {} over polished gold", alpha),
                                     {coat(1.5, alpha)}, metal("gold", 0.01)));
    add_pictures(figure, "In the studio", shown_balls(materials, run));
    const std::array slices{shown_slice(materials[0], 45.0, run),
                            shown_slice(materials[1], 45.0, run)};
    add_pictures(figure, "All light directions for a viewer at 45 degrees", slices);
    return figure;
}

Figure scattering_film_figure(const StudyRun& run) {
    Figure figure{
        "figure-14", "Figure 14: gold under a medium that scatters",
        "Gold of alpha 0.05 below a medium without interfaces, g 0.7, sigma_s 1, sigma_a 0, of "
        "growing thickness. Each crossing blurs the gold's reflection and takes light out of it; "
        "from thickness 2 on most light has been scattered several times, and what returns "
        "without having reached the gold, uncoloured, veils it. A model that does not know the "
        "medium leaves it out (plain) or refuses the material.",
        std::string{"pictures: "} + kPictureMeasure + "; " + kStatisticsMeasure};
    std::vector<Material> materials;
    for (const double thickness : {0.25, 0.5, 1.0, 2.0, 4.0})
        materials.push_back(filmed_gold(thickness));
    add_pictures(figure, "In the studio", shown_balls(materials, run));
    figure.panels.emplace_back(albedo_plots(materials[2], run));
    std::get<Plots>(figure.panels.back()).title += ", thickness 1";
    figure.panels.emplace_back(
        statistics_plots(figure, {"growing thickness", kThickness, 1.0, filmed_gold}, run));
    return figure;
}

Figure smooth_coat_figure(const StudyRun& run) {
    Figure figure{
        "figure-17", "Figure 17: a smooth coat over rough metal",
        "A coat of index 1.4 and alpha 0.01 over a metal of index 1 + i and alpha 0.1: a sharp "
        "reflection over a blurred one. The studio's edges are wider than the sharp lobe, so that "
        "single rays per pixel draw it; the slice has pixels as wide as the lobe, and models are "
        "averaged over each as the simulation is. clearcoat and plain do not refract: their metal "
        "is brighter and less blurred. stack has the right light, a little too much of it in the "
        "mirror direction; at 70 degrees what leaves the coat is spread to the sides and towards "
        "the normal, as no lobe of one roughness is.",
        kPictureMeasure};
    const Material material =
        stack_of("1.4, alpha 0.01 over 1 + i", {coat(1.4, 0.01)}, grey_conductor(1.0, 1.0, 0.1));
    add_pictures(figure, "In the studio", std::array{shown_ball(material, run)});
    add_pictures(figure, "All light directions",
                 std::array{shown_slice(material, 30.0, run), shown_slice(material, 70.0, run)});
    return figure;
}

Figure two_layer_grid_figure(const StudyRun& run) {
    Figure figure{
        "figure-22", "Figure 22: two layers, smooth to rough",
        "Gold under a coat of index 1.5, each of three roughnesses. The rougher of the two "
        "decides how the gold looks, and light that goes back and forth deepens its colour. stack "
        "is farthest off under a rough coat over smooth gold, where the peak of its lobe is too "
        "low: see figure 13.",
        kPictureMeasure};
    std::vector<Material> materials;
    for (const double top : {0.05, 0.2, 0.5})
        for (const double base : {0.05, 0.2, 0.5})
            materials.push_back(stack_of(fmt::format("alpha {} over {}", top, base),
                                         {coat(1.5, top)}, metal("gold", base)));
    add_pictures(figure, "In the studio", shown_balls(materials, run));
    return figure;
}

Figure coated_coats_figure(const StudyRun& run) {
    Figure figure{
        "figure-10-of-2022", "Figure 10 of 2022: a smooth coat over a coated Lambertian base",
        "A smooth coat of index eta_0 over one of index 2, rough or not, over a base of albedo "
        "0.9, 0.1 and 0.1. The base's light leaves by the exact lobe of any reciprocal stack; "
        "what stack has left to err in is the energy of light between rough interfaces and the "
        "shape of what the second one reflects. plain leaves out the second coat and the light "
        "between coat and base.",
        kPictureMeasure};
    std::vector<Material> materials;
    for (const double eta : {1.2, 2.0})
        for (const double alpha : {0.1, 0.4})
            materials.push_back(stack_of(fmt::format("eta_0 {}, alpha_1 {}", eta, alpha),
                                         {coat(eta, 0.0), coat(2.0, alpha)},
                                         LambertianBase{{0.9, 0.1, 0.1}}));
    add_pictures(figure, "In the studio", shown_balls(materials, run));
    return figure;
}

Figure bundled_materials_figure(const StudyRun& run) {
    Figure figure{
        "bundled-materials", "The bundled layered materials",
        "What lacquer's own materials of several layers look like, and how far each model is from "
        "that. The steel is brushed from the middle of the ball outwards; stack has one roughness "
        "for it. Each place of a glass ball is a plate, through which the room is seen: dark "
        "where a model has no transmitted lobe. plain leaves out all media, and with them most "
        "colours.",
        kPictureMeasure};
    std::vector<Material> materials;
    for (const char* name : kBundled)
        materials.push_back(
            load_material(share_folder() / "materials" / (std::string{name} + ".json")));
    add_pictures(figure, "In the studio", shown_balls(materials, run));
    return figure;
}

}  // namespace lacquer::study
