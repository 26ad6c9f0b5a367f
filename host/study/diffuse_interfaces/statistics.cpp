// Figure 3: the statistics of a coat, looked up in the tables and simulated.
#include <fmt/format.h>

#include <array>

#include "core/paths.h"
#include "simulator/interface.h"
#include "study/diffuse_interfaces/abscissa.h"
#include "study/diffuse_interfaces/albedo_plot.h"
#include "study/diffuse_interfaces/materials.h"
#include "study/diffuse_interfaces/suite.h"
#include "study/error_tally.h"
#include "study/material_pictures.h"
#include "tables/energy_tables.h"

namespace lacquer::study {

namespace {

using simulator::Estimate;
using simulator::InterfaceEstimate;

constexpr std::uint64_t kDotShare = 1 << 5;

// The coat that statistics are of; one of them varies along a plot.
struct Interface {
    double alpha, eta, tau, cos_theta;

    std::string text() const {
        return fmt::format("eta {:.3g}, alpha {:.3g}, tau {:.3g}, cos_theta {:.3g}", eta, alpha,
                           tau, cos_theta);
    }
};

// What the tables hold.
struct Quantity {
    const char* name;
    double top;  // of its plots
    Estimate InterfaceEstimate::*simulated;
    double (*look_up)(const EnergyTables&, const Interface&);
};

constexpr Quantity kEntering{"T01", 1.0, &InterfaceEstimate::t_down,
                             [](const EnergyTables& tables, const Interface& at) {
                                 return tables.t_down(at.cos_theta, at.alpha, at.eta, at.tau);
                             }};
constexpr std::array<Quantity, 3> kDiffuse{{{"R10_bar", 1.0, &InterfaceEstimate::r_up,
                                             [](const EnergyTables& tables, const Interface& at) {
                                                 return tables.r_up(at.alpha, at.eta, at.tau);
                                             }},
                                            {"T10_bar", 1.0, &InterfaceEstimate::t_up,
                                             [](const EnergyTables& tables, const Interface& at) {
                                                 return tables.t_up(at.alpha, at.eta, at.tau);
                                             }},
                                            {"sigma_2+", 0.3, &InterfaceEstimate::variance,
                                             [](const EnergyTables& tables, const Interface& at) {
                                                 return tables.variance(at.alpha, at.eta, at.tau);
                                             }}}};

// The coats of one curve.
struct Family {
    std::string label;
    std::function<Interface(double x)> at;
};

// Simulated at dot_positions(...).
using Dots = std::vector<InterfaceEstimate>;

Dots simulate_dots(const StudyRun& run, const Abscissa& over, const Family& family) {
    Dots dots;
    for (const double x : dot_positions(over)) {
        const Interface at = family.at(x);
        dots.push_back(simulator::estimate_interface(
            {Ndf::ggx, at.alpha, at.alpha}, at.eta, at.tau, at.cos_theta,
            run.options(run.share(kDotShare), "statistics " + at.text())));
    }
    return dots;
}

void add_curves(Plot& plot, const Abscissa& over, const Family& family, const Dots& dots,
                const Quantity& quantity, const EnergyTables& tables, ErrorTally& tally) {
    plot.curves.push_back(
        line(family.label, over, [&](double x) { return quantity.look_up(tables, family.at(x)); }));
    Curve simulated{"", dot_positions(over)};
    simulated.dots = true;
    for (std::size_t n = 0; n < dots.size(); ++n) {
        const Interface at = family.at(simulated.x[n]);
        const Estimate& truth = dots[n].*quantity.simulated;
        simulated.y.push_back(truth.mean);
        simulated.errors.push_back(truth.standard_error);
        tally.add(quantity.look_up(tables, at) - truth.mean, truth.standard_error,
                  [&] { return at.text(); });
    }
    plot.curves.push_back(std::move(simulated));
}

ErrorTally table_tally(const Quantity& quantity) {
    return {quantity.name, "tables"};
}

// T01 over directions.
void add_entering(const StudyRun& run, const EnergyTables& tables, Figure& figure) {
    Plots plots{"(a) Light that enters", {}};
    ErrorTally tally = table_tally(kEntering);
    for (const double eta : {0.6, 0.8, 1.5}) {
        plots.plots.push_back(
            empty_plot(fmt::format("T01, eta {}, clear", eta), kCosine, kEntering.name, 1.0));
        for (const double alpha : {0.05, 0.2, 0.5, 1.0}) {
            const Family family{fmt::format("alpha {}", alpha), [=](double cosine) {
                                    return Interface{alpha, eta, 1.0, cosine};
                                }};
            add_curves(plots.plots.back(), kCosine, family, simulate_dots(run, kCosine, family),
                       kEntering, tables, tally);
        }
    }
    figure.errors.push_back(tally.result());
    figure.panels.emplace_back(std::move(plots));
}

// The diffuse quantities over `over`, one plot each, one curve per family.
void add_diffuse(const StudyRun& run, const EnergyTables& tables, const std::string& title,
                 const Abscissa& over, const std::vector<Family>& families,
                 std::vector<ErrorTally>& tallies, Figure& figure) {
    Plots plots{title, {}};
    for (const Quantity& quantity : kDiffuse)
        plots.plots.push_back(empty_plot(fmt::format("{} over {}", quantity.name, over.name), over,
                                         quantity.name, quantity.top));
    for (const Family& family : families) {
        const Dots dots = simulate_dots(run, over, family);
        for (std::size_t n = 0; n < kDiffuse.size(); ++n)
            add_curves(plots.plots[n], over, family, dots, kDiffuse[n], tables, tallies[n]);
    }
    figure.panels.emplace_back(std::move(plots));
}

std::vector<Family> over_eta() {
    std::vector<Family> families;
    for (const double alpha : {0.05, 0.3, 1.0})
        families.push_back({fmt::format("alpha {}", alpha), [=](double eta) {
                                return Interface{alpha, eta, 1.0, 1.0};
                            }});
    return families;
}

std::vector<Family> over_tau() {
    std::vector<Family> families;
    for (const auto& [eta, alpha] : {std::pair{0.8, 0.1}, {1.5, 0.1}, {1.5, 0.6}})
        families.push_back({fmt::format("eta {}, {}", eta, alpha), [=](double tau) {
                                return Interface{alpha, eta, tau, 1.0};
                            }});
    return families;
}

// The energies of the models beside the simulation.
void add_base_energy(const StudyRun& run, Figure& figure) {
    constexpr double kAlpha = 0.1, kAlbedo = 0.8;
    Plots plots{fmt::format("(c) Light through the base, alpha {}, albedo {}", kAlpha, kAlbedo),
                {}};
    std::vector<ErrorTally> tallies;
    for (const Model model : compared_models())
        tallies.emplace_back("base's albedo", std::string{model_name(model)});
    for (const auto& [eta, tau] : {std::pair{0.8, 1.0}, {1.5, 1.0}, {1.5, 0.4}}) {
        const Material material = coated(eta, kAlpha, {kAlbedo, kAlbedo, kAlbedo}, {tau, tau, tau});
        plots.plots.push_back(
            albedo_plot({fmt::format("rho_2+, eta {}, tau {}", eta, tau), Light::base}, material,
                        models_of(material, compared_models()), tallies, run));
    }
    for (const ErrorTally& tally : tallies) figure.errors.push_back(tally.result());
    figure.panels.emplace_back(std::move(plots));
}

}  // namespace

Figure statistics_figure(const StudyRun& run) {
    run.part("statistics");
    const EnergyTables tables{share_folder() / "tables"};
    Figure figure{
        "figure-3", "Figure 3: statistics of a coated Lambertian",
        "Lines are looked up in the shipped tables, dots are simulated (bars: one standard error). "
        "Light that enters a thinner medium meets a critical angle, which roughness blurs; a "
        "denser "
        "medium keeps most diffuse light in. sigma_2+ is the variance of the light that leaves, "
        "0.25 for a Lambertian lobe; the paper has it over eta and alpha alone, but absorption "
        "narrows it too. In (c) the models' own energies stand beside the simulation.",
        "mean and largest |difference|"};
    add_entering(run, tables, figure);
    std::vector<ErrorTally> tallies;
    for (const Quantity& quantity : kDiffuse) tallies.push_back(table_tally(quantity));
    add_diffuse(run, tables, "(b, d) Diffuse light inside, and its spread; clear", kEta, over_eta(),
                tallies, figure);
    add_diffuse(run, tables, "The same by absorption; eta, alpha", kTau, over_tau(), tallies,
                figure);
    for (const ErrorTally& tally : tallies) figure.errors.push_back(tally.result());
    add_base_energy(run, figure);
    return figure;
}

}  // namespace lacquer::study
