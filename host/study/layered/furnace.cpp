// Figure 12 of 2018: five interfaces over a mirror return all light.
#include <fmt/format.h>

#include <array>

#include "study/diffuse_interfaces/abscissa.h"
#include "study/error_tally.h"
#include "study/even_point.h"
#include "study/layered/ball.h"
#include "study/layered/light_statistics.h"
#include "study/layered/stack_pictures.h"
#include "study/layered/stacks.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

constexpr std::uint64_t kDotShare = 1 << 6;
constexpr double kTop = 1.2;  // of the plots' ordinate

// Index i kappa reflects all light, whatever kappa is.
ConductorBase mirror(double alpha) {
    return grey_conductor(0.0, 10.0, alpha);
}

Material furnace(int layers, double alpha) {
    std::vector<Layer> coats;
    for (int n = 0; n < layers; ++n) coats.push_back(coat(n % 2 == 0 ? 1.3 : 1.0, alpha));
    return stack_of(fmt::format("{} layer{}, alpha {}", layers, layers == 1 ? "" : "s", alpha),
                    std::move(coats), mirror(alpha));
}

glm::dvec3 viewer_at(double cos_theta) {
    return {std::sqrt(1.0 - cos_theta * cos_theta), 0.0, cos_theta};
}

double albedo_of(const ModelLight& model, double cos_theta) {
    const reference::Albedo albedo = model.albedo(viewer_at(cos_theta));
    return albedo.direct.x + albedo.base.x;
}

// To about 0.001.
double integral_of(const ModelLight& model, double cos_theta) {
    constexpr int kPoints = 2048;
    const glm::dvec3 wo = viewer_at(cos_theta);
    double sum = 0.0;
    for (int n = 0; n < kPoints; ++n) sum += model.sample(wo, even_point(n)).weight.x;
    return sum / kPoints;
}

Curve simulated(const Material& material, const StudyRun& run) {
    Curve curve{"simulation", dot_positions(kCosine)};
    curve.dots = true;
    for (const double cosine : curve.x) {
        const Spread all = simulate_statistics(material, cosine, run.share(kDotShare), run,
                                               fmt::format("furnace {} {}", material.name, cosine))
                               .all;
        curve.y.push_back(all.energy);
        curve.errors.push_back(all.energy_error);
    }
    return curve;
}

void add_model(Plot& plot, Figure& figure, const std::string& subject, const std::string& name,
               const Curve& truth, const std::function<double(double cos_theta)>& albedo) {
    Curve curve{name, truth.x};
    ErrorTally tally{subject, name};
    for (std::size_t n = 0; n < curve.x.size(); ++n) {
        curve.y.push_back(albedo(curve.x[n]));
        tally.add(curve.y.back() - truth.y[n], truth.errors[n],
                  [&] { return fmt::format("cos_theta {:.3g}", curve.x[n]); });
    }
    plot.curves.push_back(std::move(curve));
    figure.errors.push_back(tally.result());
}

Plot furnace_plot(Figure& figure, const Material& material, const StudyRun& run) {
    run.part(material.name + ", albedo");
    Plot plot = empty_plot(material.name, kCosine, "albedo", kTop);
    const Curve truth = simulated(material, run);
    plot.curves.push_back(truth);
    for (const Compared& model : compared_on(material)) {
        if (!model.light) continue;
        // A model without a formula says what its lobes add up to.
        if (model.name == "stack")
            add_model(plot, figure, material.name, model.name, truth,
                      [&](double cosine) { return albedo_of(*model.light, cosine); });
        add_model(plot, figure, material.name,
                  model.name == "stack" ? "stack, its lobes" : model.name, truth,
                  [&](double cosine) { return integral_of(*model.light, cosine); });
    }
    return plot;
}

}  // namespace

Figure stack_furnace_figure(const StudyRun& run) {
    Figure figure{
        "figure-12", "Figure 12: five layers over a mirror lose nothing",
        "Interfaces of index 1.3 and 1 in turn over a perfect mirror, all of one roughness: all "
        "light comes back, as the dots at 1 say. The albedo of stack is 1 by construction of its "
        "energies, and so is the sum of the lobes that a renderer integrates. weidlich-wilkie and "
        "clearcoat shade the first layer alone, in the second row of plots: weidlich-wilkie loses "
        "what the coat sends back down, clearcoat what meets several facets. plain makes light "
        "from nothing near grazing.",
        "plots: mean and largest |albedo - simulated|; pictures: " + std::string{kPictureMeasure}};
    Plots five{"Albedo in a white furnace, five layers", {}}, one{"One layer over the mirror", {}};
    for (const double alpha : {0.0, 0.1, 0.4}) {
        five.plots.push_back(furnace_plot(figure, furnace(5, alpha), run));
        one.plots.push_back(furnace_plot(figure, furnace(1, alpha), run));
    }
    figure.panels.emplace_back(std::move(five));
    figure.panels.emplace_back(std::move(one));
    add_pictures(figure, "In the studio",
                 std::array{shown_ball(furnace(5, 0.1), run), shown_ball(furnace(1, 0.1), run)});
    return figure;
}

}  // namespace lacquer::study
