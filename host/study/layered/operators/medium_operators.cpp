// Figure 8 of 2018: what media do to lobes, and to rays.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/paths.h"
#include "reference/stack/layers.h"
#include "reference/stack/published/operators_2018.h"
#include "reference/stack/scattering.h"
#include "simulator/medium.h"
#include "study/layered/operators/lobes.h"
#include "study/layered/operators/operator_plot.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

namespace published = reference::published_2018;

constexpr Abscissa kDepth{"optical depth", 0.0, 3.0};
constexpr Abscissa kAnisotropy{"g", 0.05, 0.98};
constexpr std::uint64_t kDotShare = 1 << 6;
constexpr double kLeastEnergy = 0.002;  // whose statistics the simulation knows

double sine_of(double cosine) {
    return std::sqrt(std::max(1.0 - cosine * cosine, 0.0));
}

// A lobe that mirrors of roughness alpha have made of light at `cosine`, and an absorbing medium.
struct Absorbed {
    double cosine, alpha, depth;
};

Spread simulate(const Absorbed& at, const StudyRun& run) {
    const simulator::SurfaceWalk mirror = mirrors(Ndf::ggx, at.alpha);
    // One name for all depths: what a medium changes is seen through less noise.
    const std::string name = fmt::format("absorption {} {}", at.cosine, at.alpha);
    return simulate_spread(
        run.options(run.share(kDotShare), name), [&](simulator::RandomStream& random) {
            const glm::dvec3 w = mirror.cross(downwards(at.cosine), random).direction;
            return Ray{w, std::exp(-at.depth / std::max(w.z, 1e-6))};
        });
}

// What stack makes of it: averages over the light's directions, of which the mean follows.
struct AbsorbedLobe {
    double energy, sine;
};

AbsorbedLobe absorbed_by_stack(const Absorbed& at, const EnergyTables& tables) {
    const reference::StackMedium medium{reference::Energy{at.depth}};
    double energy = 0.0, before = 0.0, after = 0.0;
    for (const double cosine : tables.lobe(at.cosine, at.alpha).cosines) {
        const double share = medium.transmittance(cosine).x / double{kLobeNodes};
        energy += share;
        after += share * cosine;
        before += cosine / double{kLobeNodes};
    }
    return {energy, sine_of(std::min(at.cosine + after / energy - before, 1.0))};
}

// One quantity, for lobes of several kinds over depth.
template <typename Measure>
OperatorCheck absorption_check(OperatorCheck check, const Measure& measure,
                               const std::function<double(const Absorbed&)>& stack,
                               const std::function<double(const Absorbed&)>& paper,
                               const StudyRun& run) {
    struct Case {
        double alpha, cosine;
    };
    for (const auto& [alpha, cosine] : {Case{0.1, 0.4}, {0.5, 0.4}, {0.5, 0.9}}) {
        const auto at = [alpha = alpha, cosine = cosine](double depth) {
            return Absorbed{cosine, alpha, depth};
        };
        check.cases.push_back({fmt::format("alpha {}, cos_theta {}", alpha, cosine),
                               [=, &run](double depth) -> std::optional<Measured> {
                                   const Spread after = simulate(at(depth), run);
                                   if (after.energy < kLeastEnergy) return std::nullopt;
                                   return measure(after, simulate(at(0.0), run));
                               },
                               {{"stack", [=](double depth) { return stack(at(depth)); }},
                                {"2018", [=](double depth) { return paper(at(depth)); }}}});
    }
    return check;
}

void add_absorption(Figure& figure, NumberTable& table, const EnergyTables& tables,
                    const StudyRun& run) {
    add_check(figure, table,
              absorption_check(
                  {"absorption: energy", "energy", kDepth, 0.0, 1.0, false, {}},
                  [](const Spread& after, const Spread&) {
                      return Measured{after.energy, after.energy_error};
                  },
                  [&](const Absorbed& at) { return absorbed_by_stack(at, tables).energy; },
                  [](const Absorbed& at) { return std::exp(-at.depth / at.cosine); }, run),
              run);
    add_check(figure, table,
              absorption_check(
                  {"absorption: shift of the mean", "sine", kDepth, -0.5, 0.1, false, {}},
                  [](const Spread& after, const Spread& before) {
                      return Measured{after.mean - before.mean, after.mean_error};
                  },
                  [&](const Absorbed& at) {
                      return absorbed_by_stack(at, tables).sine - sine_of(at.cosine);
                  },
                  [](const Absorbed&) { return 0.0; }, run),
              run);
    add_check(figure, table,
              absorption_check(
                  {"absorption: width over that before", "ratio", kDepth, 0.0, 1.6, false, {}},
                  [](const Spread& after, const Spread& before) {
                      return Measured{after.width / before.width, after.width_error / before.width};
                  },
                  [](const Absorbed&) { return 1.0; }, [](const Absorbed&) { return 1.0; }, run),
              run);
}

// A ray and a medium that scatters and absorbs nothing.
struct Scattered {
    double cosine, depth, g;

    reference::ScatteringSlab slab() const { return {0.0, depth, g}; }
};

enum class Part { transmitted, scattered, back };

Spread simulate(const Scattered& at, Part part, const StudyRun& run) {
    const double depth = at.depth;
    const simulator::Slab slab =
        simulator::make_slab(ScatteringMedium{Rgb{}, {depth, depth, depth}, at.g, 1.0});
    const glm::dvec3 ray = downwards(at.cosine);
    const std::string name = fmt::format("scattering {} {} {}", at.cosine, depth, at.g);
    return simulate_spread(
        run.options(run.share(kDotShare), name), [&](simulator::RandomStream& random) {
            const simulator::Passage passage = simulator::pass_slab(slab, ray, random);
            const bool is_wanted = part == Part::back ? !passage.down
                                   : part == Part::transmitted
                                       ? passage.down
                                       : passage.down && passage.direction != ray;
            return Ray{passage.direction, is_wanted && !passage.lost ? passage.weight.x : 0.0};
        });
}

// Per axis, of a spread of both.
double width_of_spread(double spread) {
    return std::sqrt(0.5 * spread);
}

// The lobe of 2018, Eq. 21, as a GGX lobe.
double width_2018(const Scattered& at) {
    const double variance = reference::scattering_variance_2018(at.g);
    return ggx_lobe(published::alpha_of_variance(variance), at.cosine).width;
}

// With the light that was not scattered, about one mean.
double width_of_all_2018(const Scattered& at) {
    const reference::SlabLight light = slab_light_2018(at.slab(), at.cosine);
    return width_2018(at) * std::sqrt(light.scattered / light.transmitted());
}

OperatorCheck scattering_check(OperatorCheck check, Part part, double Spread::*value,
                               double Spread::*error,
                               const std::function<double(const Scattered&)>& stack,
                               const std::function<double(const Scattered&)>& paper,
                               const StudyRun& run) {
    struct Case {
        double depth, cosine;
    };
    for (const auto& [depth, cosine] : {Case{0.25, 1.0}, {2.0, 1.0}, {1.0, 0.4}}) {
        const auto at = [depth = depth, cosine = cosine](double g) {
            return Scattered{cosine, depth, g};
        };
        check.cases.push_back({fmt::format("depth {}, cos_theta {}", depth, cosine),
                               [=, &run](double g) -> std::optional<Measured> {
                                   const Spread spread = simulate(at(g), part, run);
                                   const bool is_energy = value == &Spread::energy;
                                   if (!is_energy && spread.energy < kLeastEnergy)
                                       return std::nullopt;
                                   return Measured{spread.*value, spread.*error};
                               },
                               {{"stack", [=](double g) { return stack(at(g)); }},
                                {"2018", [=](double g) { return paper(at(g)); }}}});
    }
    return check;
}

void add_scattering(Figure& figure, NumberTable& table, const StudyRun& run) {
    using reference::slab_light;
    using reference::slab_light_2018;
    const auto energy = [&](const char* subject, Part part,
                            const std::function<double(const reference::SlabLight&)>& of) {
        add_check(
            figure, table,
            scattering_check(
                {subject, "energy", kAnisotropy, 0.0, 1.0, false, {}}, part, &Spread::energy,
                &Spread::energy_error,
                [=](const Scattered& at) { return of(slab_light(at.slab(), at.cosine)); },
                [=](const Scattered& at) { return of(slab_light_2018(at.slab(), at.cosine)); },
                run),
            run);
    };
    const auto width = [&](const char* subject, Part part,
                           const std::function<double(const Scattered&)>& stack,
                           const std::function<double(const Scattered&)>& paper) {
        add_check(figure, table,
                  scattering_check({subject, "width", kAnisotropy, 0.0, 0.6, true, {}}, part,
                                   &Spread::width, &Spread::width_error, stack, paper, run),
                  run);
    };
    energy("scattering: light let through", Part::transmitted,
           [](const reference::SlabLight& light) { return light.transmitted(); });
    energy("scattering: light sent back", Part::back,
           [](const reference::SlabLight& light) { return light.back; });
    width(
        "scattering: width of what was scattered", Part::scattered,
        [](const Scattered& at) {
            const auto light = slab_light(at.slab(), at.cosine);
            return width_of_spread(scattered_lobe(at.slab(), at.cosine, light).spread);
        },
        width_2018);
    width(
        "scattering: width of all let through", Part::transmitted,
        [](const Scattered& at) {
            return width_of_spread(transmitted_lobe(at.slab(), at.cosine).spread);
        },
        width_of_all_2018);
}

}  // namespace

Figure medium_operators_figure(const StudyRun& run) {
    const EnergyTables tables{share_folder() / "tables"};
    Figure figure{
        "figure-8", "Figure 8: absorption and scattering",
        "Absorption: a lobe that perfect GGX mirrors have made of light at cos_theta, and what a "
        "medium leaves of it. stack averages over the directions of the lobe; 2018 takes one "
        "direction and leaves the mean where it was (Eqs. 15 to 17). stack's mean follows from "
        "that of the cosines, which serves light at a slant and overshoots where a wide lobe is "
        "near the normal. Neither changes the width, and that is not negligible: oblique light "
        "has the longer way, so that a deep medium takes a quarter of a wide lobe's width and "
        "gives a narrow one at a slant a half more. Scattering: a ray, and a medium that absorbs "
        "nothing. 2018 is Eqs. 20 to 24: light scattered once, of the width of Eq. 21, none sent "
        "back; right for thin media and g from 0.7 on. stack follows all orders by two streams.",
        "energies and means: mean and largest |difference|; widths: the same, as a share of the "
        "simulated, or of that before the medium"};
    NumberTable table = operator_table();
    add_absorption(figure, table, tables, run);
    add_scattering(figure, table, run);
    figure.panels.emplace_back(std::move(table));
    return figure;
}

}  // namespace lacquer::study
