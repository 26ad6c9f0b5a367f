#include "study/layered/statistics_plot.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "study/error_tally.h"
#include "study/layered/compared.h"
#include "study/layered/light_statistics.h"

namespace lacquer::study {

const char* const kStatisticsMeasure =
    "albedo: mean and largest |difference|; width: the same, as a share of the simulated width "
    "(the standard deviation of directions on the projected disk)";

namespace {

constexpr std::uint64_t kDotShare = 1 << 6;
constexpr double kLeastEnergy = 0.01;  // whose width the simulation knows
constexpr double kLeastWidth = 0.01;   // models have no lobes narrower than alpha 0.001
constexpr double kWidthTop = 0.6;      // a Lambertian surface has 0.5

struct Quantity {
    const char* name;
    double top;
    bool is_width;
    Spread LightStatistics::*of;

    bool has(const LightStatistics& truth) const {
        const Spread& spread = truth.*of;
        return !is_width || (spread.energy >= kLeastEnergy && spread.width >= kLeastWidth);
    }
    double value(const LightStatistics& all) const {
        return is_width ? (all.*of).width : (all.*of).energy;
    }
    double error(const LightStatistics& all) const {
        return is_width ? (all.*of).width_error : (all.*of).energy_error;
    }
};

constexpr std::array<Quantity, 3> kQuantities{{
    {"albedo", 1.0, false, &LightStatistics::all},
    {"width of all light", kWidthTop, true, &LightStatistics::all},
    {"width of light from the base", kWidthTop, true, &LightStatistics::base},
}};

// At one dot.
struct Dot {
    double x;
    LightStatistics truth;
    std::vector<std::pair<std::string, LightStatistics>> models;
};

Dot measure(const StackFamily& family, double x, const StudyRun& run) {
    const Material material = family.at(x);
    Dot dot{x,
            simulate_statistics(material, family.cos_theta_o, run.share(kDotShare), run,
                                fmt::format("{} {}", family.name, x)),
            {}};
    for (const Compared& model : compared_on(material, Need::base))
        if (model.light)
            dot.models.emplace_back(model.name, model_statistics(*model.light, family.cos_theta_o));
    return dot;
}

Curve simulated(const Quantity& quantity, const std::vector<Dot>& dots) {
    Curve curve{"simulation"};
    curve.dots = true;
    for (const Dot& dot : dots) {
        if (!quantity.has(dot.truth)) continue;
        curve.x.push_back(dot.x);
        curve.y.push_back(quantity.value(dot.truth));
        curve.errors.push_back(quantity.error(dot.truth));
    }
    return curve;
}

// That of a model, and its errors.
Curve modelled(const Quantity& quantity, const std::vector<Dot>& dots, const std::string& name,
               const StackFamily& family, Figure& figure) {
    Curve curve{name};
    ErrorTally tally{family.name + ", " + quantity.name, name};
    for (const Dot& dot : dots) {
        const auto model =
            std::ranges::find(dot.models, name, &std::pair<std::string, LightStatistics>::first);
        if (model == dot.models.end() || !quantity.has(dot.truth)) continue;
        const double truth = quantity.value(dot.truth), value = quantity.value(model->second);
        const double scale = quantity.is_width ? truth : 1.0;
        curve.x.push_back(dot.x);
        curve.y.push_back(value);
        tally.add((value - truth) / scale, quantity.error(dot.truth) / scale,
                  [&] { return fmt::format("{} {:.3g}", family.over.name, dot.x); });
    }
    if (!curve.x.empty()) figure.errors.push_back(tally.result());
    return curve;
}

}  // namespace

Plots statistics_plots(Figure& figure, const StackFamily& family, const StudyRun& run) {
    run.part(family.name);
    std::vector<Dot> dots;
    for (const double x : dot_positions(family.over)) dots.push_back(measure(family, x, run));
    Plots plots{family.name, {}};
    for (const Quantity& quantity : kQuantities) {
        Plot plot = empty_plot(quantity.name, family.over, quantity.name, quantity.top);
        plot.curves.push_back(simulated(quantity, dots));
        for (const auto& [name, statistics] : dots.back().models)
            plot.curves.push_back(modelled(quantity, dots, name, family, figure));
        plots.plots.push_back(std::move(plot));
    }
    return plots;
}

}  // namespace lacquer::study
