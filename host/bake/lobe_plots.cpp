// The plots of Belcour 2018 that motivate its operators on statistics, by the simulator: figures 3
// to 6, and the simulated curves of figure 21.
#include "bake/lobe_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bake/lobe_statistics.h"
#include "markup/plot.h"

namespace lacquer::bake {

namespace {

constexpr std::uint64_t kWalks = 40'000;  // per point of a curve: a thousandth of its height
constexpr std::uint64_t kSeed = 1;
constexpr int kPoints = 24;

template <typename Value>
Curve curve_of(const std::string& label, double to, const Value& value, bool dashed = false) {
    Curve curve{label, {}, {}, dashed};
    for (int n = 0; n <= kPoints; ++n) {
        const double x = to * n / kPoints;
        curve.x.push_back(x);
        curve.y.push_back(value(x));
    }
    return curve;
}

double variance_of(const LobeWalk& walk) {
    return lobe_statistics(walk, kWalks, kSeed).variance;
}

// Linear space of variances, Belcour 2018, Eq. 6, and back.
double linear_variance(double alpha) {
    const double power = std::pow(std::min(alpha, 0.999), 1.1);
    return power / (1.0 - power);
}

double roughness_of(double variance) {
    return std::pow(variance / (1.0 + variance), 1.0 / 1.1);
}

std::string variance_plot() {
    Plot plot{"Variance (figure 3)", "alpha", "variance", 0, 1, 0, 0.3, {}};
    plot.curves.push_back(curve_of(
        "one bounce", 1.0, [](double alpha) { return variance_of(reflected_lobe(alpha, 0.0)); }));
    plot.curves.push_back(curve_of("two bounces", 1.0, [](double alpha) {
        return variance_of(twice_reflected_lobe(alpha, alpha));
    }));
    return svg_of(plot);
}

std::string two_bounces_plot(const EquivalentRoughness& equivalent) {
    Plot plot{"Two bounces; Eq. 6 dashed (figure 4)",
              "alpha of the second",
              "equivalent alpha",
              0,
              1,
              0,
              1,
              {}};
    for (const double first : {0.0, 0.1, 0.2, 0.4, 0.7}) {
        plot.curves.push_back(curve_of(fmt::format("first {}", first), 1.0, [&](double second) {
            return equivalent(variance_of(twice_reflected_lobe(first, second)));
        }));
        plot.curves.push_back(curve_of(
            "", 1.0,
            [&](double second) {
                return roughness_of(linear_variance(first) + linear_variance(second));
            },
            true));
    }
    return svg_of(plot);
}

std::string transmitted_mean_plot(double alpha) {
    Plot plot{fmt::format("Mean, alpha {}; Snell dashed (figure 5)", alpha),
              "|mu_i|",
              "|mu_t|",
              0,
              1,
              0,
              1,
              {}};
    for (const double eta : {1.1, 1.3, 1.5, 2.0}) {
        plot.curves.push_back(curve_of(fmt::format("eta {}", eta), 1.0, [&](double sine) {
            const LobeWalk walk = transmitted_lobe(alpha, eta, std::min(sine, 0.999));
            return std::abs(lobe_statistics(walk, kWalks, kSeed).mean_x);
        }));
        plot.curves.push_back(curve_of(
            "", 1.0, [&](double sine) { return sine / eta; }, true));
    }
    return svg_of(plot);
}

// Of the light near the plane of incidence, by the sine of the outgoing angle; the largest is 1.
Curve scaled_lobe(const std::string& label, const LobeWalk& walk) {
    constexpr int kBins = 81;
    constexpr double kOutOfPlane = 0.05;  // sine, of what is counted
    constexpr std::uint64_t kLobeWalks = 1'000'000;
    std::vector<double> bins(kBins, 0.0);
    for (std::uint64_t n = 0; n < kLobeWalks; ++n) {
        simulator::RandomStream random{kSeed, n};
        simulator::Vec3 w;
        double weight = 1.0;
        if (!walk(random, w, weight) || std::abs(w.y) > kOutOfPlane) continue;
        const auto bin = static_cast<std::size_t>(0.5 * (1.0 + w.x) * kBins);
        bins[std::min(bin, bins.size() - 1)] += weight;
    }
    const double top = *std::max_element(bins.begin(), bins.end());
    Curve curve{label, {}, {}, false};
    for (int n = 0; n < kBins; ++n) {
        curve.x.push_back(2.0 * (n + 0.5) / kBins - 1.0);
        curve.y.push_back(bins[static_cast<std::size_t>(n)] / top);
    }
    return curve;
}

std::string widths_plot() {
    constexpr double kSine = 0.5, kAlpha = 0.2, kEta = 1.5;  // 30 degrees
    return svg_of({fmt::format("Lobes at 30 degrees, alpha {} (figure 6)", kAlpha),
                   "sine of the outgoing angle",
                   "scaled to 1",
                   -1,
                   1,
                   0,
                   1,
                   {scaled_lobe("transmitted", transmitted_lobe(kAlpha, kEta, kSine)),
                    scaled_lobe("reflected", reflected_lobe(kAlpha, kSine))}});
}

std::string stacks_plot(const EquivalentRoughness& equivalent) {
    Plot plot{"Stacks (figure 21)", "alpha of the top", "equivalent alpha", 0, 1, 0, 1, {}};
    plot.curves.push_back(curve_of("two layers", 1.0, [&](double alpha) {
        return equivalent(variance_of(stack_lobe({{1.4, alpha}}, 0.3)));
    }));
    plot.curves.push_back(curve_of("four layers", 1.0, [&](double alpha) {
        return equivalent(variance_of(stack_lobe({{1.4, alpha}, {1.2, 0.1}, {1.4, 0.1}}, 0.01)));
    }));
    return svg_of(plot);
}

}  // namespace

std::string lobe_plots() {
    const EquivalentRoughness equivalent{4 * kWalks, kSeed};
    return variance_plot() + two_bounces_plot(equivalent) + transmitted_mean_plot(0.1) +
           transmitted_mean_plot(0.5) + widths_plot() + stacks_plot(equivalent);
}

}  // namespace lacquer::bake
