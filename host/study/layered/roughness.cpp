// Figures 19 and 21 of 2018: how albedo and width go with roughness.
#include <fmt/format.h>

#include <array>

#include "study/layered/stack_pictures.h"
#include "study/layered/stacks.h"
#include "study/layered/statistics_plot.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

constexpr Abscissa kAlpha{"alpha", 0.0, 1.0};
constexpr Abscissa kTopAlpha{"alpha_0", 0.0, 1.0};

Material equally_rough(double alpha) {
    return stack_of(fmt::format("alpha {}", alpha), {coat(2.0, alpha)},
                    grey_conductor(0.01, 1.0, alpha));
}

Material two_layers(double alpha) {
    return stack_of("two layers", {coat(1.4, alpha)}, grey_conductor(1.0, 1.0, 0.3));
}

Material four_layers(double alpha) {
    return stack_of("four layers", {coat(1.4, alpha), coat(1.2, 0.1), coat(1.4, 0.1)},
                    grey_conductor(1.0, 1.0, 0.01));
}

}  // namespace

Figure equal_roughness_figure(const StudyRun& run) {
    Figure figure{
        "figure-19", "Figure 19: coat and metal equally rough",
        "A coat of index 2 over a metal of index 0.01 + i, which absorbs next to nothing. The "
        "paper left out light that meets several facets of one interface; here both have it. The "
        "balls of stack are near at all roughnesses, its lobes are not: at alpha 0.3 they still "
        "point forwards where simulated light has forgotten where it came from, at 0.8 they send "
        "too much to the horizon and too little along the normal. weidlich-wilkie, clearcoat and "
        "plain lose the light that goes back and forth, which is most of it.",
        std::string{"pictures: "} + kPictureMeasure + "; " + kStatisticsMeasure};
    std::vector<Shown> shown;
    for (const double alpha : {0.1, 0.3, 0.5, 0.8, 1.0})
        shown.push_back(shown_ball(equally_rough(alpha), run));
    add_pictures(figure, "In the studio", shown);
    add_pictures(figure, "All light directions for a viewer at 45 degrees",
                 std::array{shown_slice(equally_rough(0.3), 45.0, run),
                            shown_slice(equally_rough(0.8), 45.0, run)});
    for (const double cosine : {1.0, 0.5})
        figure.panels.emplace_back(statistics_plots(
            figure,
            {fmt::format("equal roughness, cos_theta_o {}", cosine), kAlpha, cosine, equally_rough},
            run));
    return figure;
}

Figure variance_figure(const StudyRun& run) {
    Figure figure{
        "figure-21", "Figure 21: the width of a stack's light",
        "Seen along the normal. Two layers: index 1.4 of alpha_0 over 1 + i of alpha 0.3. Four: "
        "1.4 of alpha_0, 1.2 and 1.4 of alpha 0.1 over 1 + i of alpha 0.01. The width is the "
        "standard deviation of directions on the projected disk, per axis. stack adds variances "
        "in a space where those of GGX lobes nearly add: two layers come out within a tenth, four "
        "too "
        "wide, most of all where every lobe is narrow. plain, clearcoat and weidlich-wilkie give "
        "the light from the metal the width that it has without a coat; plain leaves out the "
        "inner layers.",
        kStatisticsMeasure};
    figure.panels.emplace_back(
        statistics_plots(figure, {"two layers", kTopAlpha, 1.0, two_layers}, run));
    figure.panels.emplace_back(
        statistics_plots(figure, {"four layers", kTopAlpha, 1.0, four_layers}, run));
    return figure;
}

}  // namespace lacquer::study
