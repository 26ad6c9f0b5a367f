#include "study/layered/operators/lobe_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "study/layered/error_sizes.h"
#include "study/layered/operators/refracted_lobe.h"

namespace lacquer::study {

namespace {

constexpr double kFrom = -1.0, kTo = 1.0;  // of x on the projected disk
constexpr int kBins = 80;
constexpr double kBinWidth = (kTo - kFrom) / kBins;
constexpr std::uint64_t kShare = 1 << 5;
constexpr int kLobePoints = 1 << 15;
constexpr double kCosine = 0.866;  // 30 degrees
constexpr const char* kSubject = "shape of one refracted ray";

// Light by its direction's x, all y together.
struct Histogram {
    std::array<double, kBins> weights{};
    std::uint64_t count = 0;

    void add(const Ray& ray) {
        const double place = (ray.direction.x - kFrom) / kBinWidth;
        weights[static_cast<std::size_t>(std::clamp(place, 0.0, kBins - 1.0))] += ray.weight;
    }
    void merge(const Histogram& more) {
        for (std::size_t bin = 0; bin < kBins; ++bin) weights[bin] += more.weights[bin];
    }
    double all() const {
        double sum = 0.0;
        for (const double weight : weights) sum += weight;
        return sum;
    }
};

// Of rays of weight 1 or 0.
template <typename Walk>
Histogram simulate(const Walk& walk, const std::string& name, const StudyRun& run) {
    return simulator::run_walks<Histogram>(
        run.options(run.share(kShare), name),
        [&](simulator::RandomStream& random, Histogram& sum) { sum.add(walk(random)); });
}

Histogram histogram_of(const FakeLobe& lobe) {
    Histogram histogram;
    for (int n = 0; n < kLobePoints; ++n)
        histogram.add(lobe_ray(lobe.alpha, lobe.cosine(), n, kLobePoints));
    return histogram;
}

Curve curve_of(const std::string& label, const Histogram& histogram) {
    Curve curve{label};
    const double scale = 1.0 / (histogram.all() * kBinWidth);
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        curve.x.push_back(kFrom + (static_cast<double>(bin) + 0.5) * kBinWidth);
        curve.y.push_back(histogram.weights[bin] * scale);
    }
    return curve;
}

Curve dots_of(const Histogram& histogram) {
    Curve curve = curve_of("simulation", histogram);
    curve.dots = true;
    for (const double weight : histogram.weights)
        curve.errors.push_back(std::sqrt(weight) / (histogram.all() * kBinWidth));
    return curve;
}

// Total variation distance of two curves.
void add_distance(const Curve& curve, const Curve& dots, const std::string& where,
                  ErrorSizes& errors) {
    double distance = 0.0, noise = 0.0;
    for (std::size_t bin = 0; bin < kBins; ++bin) {
        distance += 0.5 * std::abs(curve.y[bin] - dots.y[bin]) * kBinWidth;
        noise += 0.5 * dots.errors[bin] * kBinWidth;
    }
    errors.add(distance, noise, [&] { return where; });
}

// By perfect mirrors: Fresnel's factor changes little of the shape.
Histogram reflected(const Refraction& at, const StudyRun& run) {
    const simulator::SurfaceWalk surface = mirrors(Ndf::ggx, at.alpha);
    return simulate(
        [&](simulator::RandomStream& random) {
            return Ray{surface.cross(downwards(at.cosine), random).direction, 1.0};
        },
        fmt::format("reflected shape {}", at.alpha), run);
}

}  // namespace

void add_lobe_shapes(Figure& figure, NumberTable& table, const StudyRun& run) {
    const std::vector<FakeLobeModel> models = fake_lobes();
    std::vector<ErrorSizes> errors;
    for (const FakeLobeModel& model : models) errors.emplace_back(kSubject, model.name);
    Plots plots{"Refracted light over the plane of incidence, and the reflection; 30 degrees", {}};
    for (const double alpha : {0.1, 0.3, 0.6}) {
        const Refraction at{kCosine, alpha, 1.5};
        const std::string title = fmt::format("eta 1.5, alpha {}", alpha);
        run.part(std::string{kSubject} + ", " + title);
        const Histogram truth =
            simulate(RefractedRays{at}, fmt::format("refracted shape {}", alpha), run);
        Plot plot{title, "sine in the plane", "density", kFrom, kTo, 0.0, 0.0};
        plot.curves.push_back(dots_of(truth));
        for (std::size_t n = 0; n < models.size(); ++n) {
            plot.curves.push_back(curve_of(models[n].name, histogram_of(models[n].lobe(at))));
            add_distance(plot.curves.back(), plot.curves.front(), title, errors[n]);
        }
        plot.curves.push_back(curve_of("reflection", reflected(at, run)));
        for (const Curve& curve : plot.curves)
            plot.y_to = std::max(plot.y_to, 1.02 * *std::ranges::max_element(curve.y));
        plots.plots.push_back(std::move(plot));
    }
    figure.panels.emplace_back(std::move(plots));
    for (const ErrorSizes& of : errors) {
        figure.errors.push_back(of.result());
        table.rows.push_back(of.row());
    }
}

}  // namespace lacquer::study
