// The page of plots.
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "bake/lobe_plots.h"
#include "bake/report.h"
#include "markup/plot.h"

namespace lacquer::bake {

namespace {

constexpr int kPoints = 120;

Curve curve_over(const std::string& label, double from, double to,
                 const std::function<double(double)>& value) {
    Curve curve{label, {}, {}, false};
    for (int n = 0; n <= kPoints; ++n) {
        const double x = from + (to - from) * n / kPoints;
        curve.x.push_back(x);
        curve.y.push_back(value(x));
    }
    return curve;
}

// de Dinechin and Belcour 2022, figure 3 (a).
std::string entering_plots(const EnergyTables& tables) {
    std::string html;
    for (const double eta : {0.6, 0.8, 1.5, 2.0}) {
        Plot plot{fmt::format("T01, eta {}", eta), "cos_theta", "T01", 0, 1, 0, 1, {}};
        for (const double alpha : {0.01, 0.1, 0.3, 0.6, 1.0})
            plot.curves.push_back(
                curve_over(fmt::format("alpha {}", alpha), 0, 1,
                           [&](double cosine) { return tables.t_down(cosine, alpha, eta, 1.0); }));
        html += svg_of(plot);
    }
    return html;
}

// Figure 3 (b, d): diffuse energies and the variance, over eta.
std::string diffuse_plots(const EnergyTables& tables) {
    constexpr double kFrom = 1.0 / 3.0, kTo = 3.0;
    using Value = std::function<double(double, double)>;  // of alpha, eta
    const auto plot_of = [&](const std::string& name, double top, const Value& value) {
        Plot plot{name, "eta", name, kFrom, kTo, 0, top, {}};
        for (const double alpha : {0.01, 0.1, 0.3, 0.6, 1.0})
            plot.curves.push_back(curve_over(fmt::format("alpha {}", alpha), kFrom, kTo,
                                             [&](double eta) { return value(alpha, eta); }));
        return svg_of(plot);
    };
    return plot_of("R10_bar", 1.0, [&](double a, double e) { return tables.r_up(a, e, 1.0); }) +
           plot_of("T10_bar", 1.0, [&](double a, double e) { return tables.t_up(a, e, 1.0); }) +
           plot_of("sigma_2+", 0.3, [&](double a, double e) { return tables.variance(a, e, 1.0); });
}

// Figure 3 (c): the energy of the base's light, Eq. 3.
std::string base_plots(const EnergyTables& tables) {
    constexpr double kAlbedo = 0.8, kAlpha = 0.1;
    std::string html;
    for (const double eta : {0.8, 1.5}) {
        Plot plot{fmt::format("rho_2+, albedo {}, alpha {}, eta {}", kAlbedo, kAlpha, eta),
                  "cos_theta",
                  "rho_2+",
                  0,
                  1,
                  0,
                  1,
                  {}};
        for (const double tau : {1.0, 0.8, 0.5, 0.2}) {
            const double gain = kAlbedo * tables.t_up(kAlpha, eta, tau) /
                                (1.0 - kAlbedo * tables.r_up(kAlpha, eta, tau));
            plot.curves.push_back(curve_over(fmt::format("tau {}", tau), 0, 1, [&](double cosine) {
                return gain * tables.t_down(cosine, kAlpha, eta, tau);
            }));
        }
        html += svg_of(plot);
    }
    return html;
}

// Figure 5: what compression leaves of T01, against fresh simulation (dashed).
std::string compression_plots(const EnergyTables& tables) {
    const Check check = all_checks().front();
    const SobolPoints points{1 << 13};
    std::string html;
    for (const double eta : {0.7, 1.3}) {
        Plot plot{fmt::format("T01, alpha 0.2, eta {}", eta), "cos_theta", "T01", 0, 1, 0, 1, {}};
        for (const double tau : {1.0, 0.5}) {
            constexpr double kAlpha = 0.2;
            plot.curves.push_back(curve_over(fmt::format("tau {}", tau), 0, 1, [&](double cosine) {
                return tables.t_down(cosine, kAlpha, eta, tau);
            }));
            Curve simulated{"", {}, {}, true};
            for (int n = 0; n <= 24; ++n) {
                const double cosine = n / 24.0;
                simulated.x.push_back(cosine);
                simulated.y.push_back(
                    check.simulate({cosine, kAlpha, eta, tau}, points, mix_bits(n + 1)));
            }
            plot.curves.push_back(simulated);
        }
        html += svg_of(plot);
    }
    return html;
}

// Figure 5: errors by the number of basis functions, as powers of ten.
std::string truncation_plots(const BakeRecord& record) {
    std::string html;
    for (const Truncation& truncation : record.truncations) {
        Curve mean{"mean", {}, {}, false}, p99{"p99", {}, {}, false};
        for (std::size_t n = 0; n < truncation.mean.size(); ++n) {
            const auto kept = static_cast<double>(n + 1);
            mean.x.push_back(kept);
            mean.y.push_back(std::log10(truncation.mean[n]));
            p99.x.push_back(kept);
            p99.y.push_back(std::log10(truncation.p99[n]));
        }
        html += svg_of({truncation.functions,
                        "functions kept",
                        "log10 of the error",
                        0,
                        static_cast<double>(truncation.mean.size()),
                        -4,
                        0,
                        {mean, p99}});
    }
    return html;
}

std::string errors_row(const std::string& name, const ErrorSummary& errors) {
    return fmt::format("<tr><td>{}</td><td>{:.5f}</td><td>{:.4f}</td><td>{:.4f}</td></tr>", name,
                       errors.mean, errors.p99, errors.max);
}

std::string errors_table(const BakeRecord& record) {
    std::string html = "<table><tr><th>quantity</th><th>mean</th><th>p99</th><th>max</th></tr>";
    for (const CheckRecord& check : record.checks) html += errors_row(check.name, check.off_grid);
    return html + "</table>";
}

std::string section(const std::string& title, const std::string& caption,
                    const std::string& content) {
    return fmt::format("<section><h2>{}</h2><p>{}</p>{}</section>", title, caption, content);
}

constexpr const char* kHead =
    R"(<!doctype html><html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width"><title>Lacquer: baked tables</title><style>
:root{color-scheme:light dark;--paper:#f6f4f0;--ink:#211d1a;--soft:#746b62;--line:#e2dcd3}
@media(prefers-color-scheme:dark){:root{--paper:#141211;--ink:#ece6de;--soft:#a0968b;--line:#35302b}}
body{font:15px/1.5 system-ui,sans-serif;margin:2em auto;max-width:1200px;padding:0 1em;
color:var(--ink);background:var(--paper)}
p{max-width:80ch;color:var(--soft);margin:0 0 10px}section{margin-top:34px}h2{margin:0 0 4px;font-size:21px}
svg{margin:0 10px 14px 0}table{border-collapse:collapse}td,th{padding:2px 18px 2px 0;text-align:left;border-bottom:1px solid var(--line);
font-variant-numeric:tabular-nums}
)";

constexpr const char* kTitle = "</style></head><body><h1>Lacquer: baked tables</h1>";

}  // namespace

std::string report_page(const EnergyTables& tables, const BakeRecord& record) {
    std::string html = std::string{kHead} + kPlotStyle + kTitle;
    html += fmt::format("<p><code>{}</code>, {} walks per node, seed {}; {:.1f} KiB in all.</p>",
                        record.command, record.settings.samples, record.settings.seed,
                        static_cast<double>(tables.bytes()) / 1024.0);
    html += section("Errors against fresh simulation",
                    fmt::format("Look-ups at {} random points of the whole range.", record.points),
                    errors_table(record));
    html +=
        section("Light that enters (2022, figure 3 a)",
                "T01 of a clear medium. Below eta 1 a smooth interface lets nothing in past its "
                "critical angle; roughness blurs that edge. Above eta 1 rough facets let more in "
                "at grazing angles than smooth ones do.",
                entering_plots(tables));
    html += section("Diffuse light inside, and its spread (figure 3 b, d)",
                    "A denser medium keeps most diffuse light in. A thinner one narrows the light "
                    "that leaves, the more the smoother; 0.25 is a Lambertian lobe.",
                    diffuse_plots(tables));
    html += section("Light through the base (figure 3 c)",
                    "The directional albedo rho_2+ of Eq. 3: absorption tints grazing angles more, "
                    "where paths are longer.",
                    base_plots(tables));
    html += section("Compression (figure 5)",
                    "The table (solid) against simulation (dashed), and errors by the number of "
                    "basis functions kept.",
                    compression_plots(tables) + truncation_plots(record));
    html += section("Lobes of rough surfaces (2018, figures 3 to 6 and 21)",
                    "Mean and variance on the projected disk, by the simulator; what the operators "
                    "on statistics approximate is dashed.",
                    lobe_plots());
    return html + "</body></html>\n";
}

}  // namespace lacquer::bake
