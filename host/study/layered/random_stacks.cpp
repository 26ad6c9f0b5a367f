// Albedos of random stacks of one to four coats.
#include "study/layered/random_stacks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "simulator/albedo.h"
#include "study/layered/compared.h"
#include "study/layered/error_sizes.h"
#include "study/layered/stacks.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

constexpr int kStacks = 40;  // of each number of coats over each base
constexpr int kMostCoats = 4;
constexpr std::uint64_t kStackShare = 1 << 6;

double uniform(std::mt19937_64& generator, double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(generator);
}

Rgb uniform_rgb(std::mt19937_64& generator, double low, double high) {
    Rgb rgb;
    for (double& channel : rgb) channel = uniform(generator, low, high);
    return rgb;
}

}  // namespace

RandomStack random_stack(std::mt19937_64& generator, BaseKind kind, int coats) {
    constexpr double kMaxAlpha = 0.8, kMinTau = 0.3;
    std::vector<Layer> layers;
    for (int n = 0; n < coats; ++n) {
        const double ior = uniform(generator, 1.0, 2.2);
        const double alpha = uniform(generator, 0.0, kMaxAlpha);
        layers.push_back(coat(ior, alpha, uniform_rgb(generator, kMinTau, 1.0)));
    }
    Base base = LambertianBase{uniform_rgb(generator, 0.0, 1.0)};
    if (kind == BaseKind::conductor) {
        ConductorBase conductor = grey_conductor(1.0, 1.0, uniform(generator, 0.0, kMaxAlpha));
        conductor.eta = uniform_rgb(generator, 0.1, 3.0);
        conductor.kappa = uniform_rgb(generator, 0.5, 8.0);
        base = conductor;
    }
    const double cosine = uniform(generator, 0.05, 1.0);
    return {stack_of("", std::move(layers), std::move(base)), cosine};
}

std::string describe(const RandomStack& sample, std::size_t channel) {
    std::string text = fmt::format("cos_theta {:.2f}", sample.cos_theta);
    for (const Layer& layer : sample.material.layers)
        text += fmt::format(", [ior {:.2f}, alpha {:.2f}, tau {:.2f}]", layer.interface.ior,
                            std::get<Microsurface>(layer.interface.roughness).alpha[0],
                            std::get<AbsorbingMedium>(layer.medium).tau[channel]);
    if (const auto* lambertian = std::get_if<LambertianBase>(&sample.material.base))
        return text + fmt::format(", albedo {:.2f}", lambertian->albedo[channel]);
    const auto& base = std::get<ConductorBase>(sample.material.base);
    return text + fmt::format(", {:.2f} + {:.2f} i, alpha {:.2f}", base.eta[channel],
                              base.kappa[channel], std::get<Microsurface>(base.roughness).alpha[0]);
}

namespace {

void measure(const RandomStack& sample, const std::string& subject, const std::string& seed,
             const StudyRun& run, std::map<std::string, ErrorSizes>& errors) {
    const auto truth =
        simulator::estimate_albedo(simulator::StackWalk{sample.material}, sample.cos_theta,
                                   run.options(run.share(kStackShare), seed));
    const glm::dvec3 wo{std::sqrt(1.0 - sample.cos_theta * sample.cos_theta), 0.0,
                        sample.cos_theta};
    for (const Compared& model : compared_on(sample.material)) {
        if (!model.light) continue;
        const reference::Albedo albedo = model.light->albedo(wo);
        ErrorSizes& of = errors.try_emplace(model.name, subject, model.name).first->second;
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int c = static_cast<int>(channel);
            const double error = albedo.direct[c] + albedo.base[c] - truth.total.mean[channel];
            of.add(error, truth.total.standard_error[channel],
                   [&] { return describe(sample, channel); });
        }
    }
}

// The row of each model, and its errors.
void add_kind(Figure& figure, NumberTable& table, BaseKind kind, int coats, const StudyRun& run) {
    const std::string subject =
        fmt::format("{} coat{} over {}", coats, coats == 1 ? "" : "s",
                    kind == BaseKind::conductor ? "conductors" : "Lambertian bases");
    std::mt19937_64 generator{run.seed_of(subject)};
    std::map<std::string, ErrorSizes> errors;
    for (int n = 0; n < kStacks; ++n) {
        run.part(fmt::format("random stack {} of {}", n + 1, subject));
        measure(random_stack(generator, kind, coats), subject, fmt::format("{} {}", subject, n),
                run, errors);
    }
    for (const Compared& model : compared_on(random_stack(generator, kind, coats).material)) {
        const auto found = errors.find(model.name);
        if (found == errors.end()) continue;
        figure.errors.push_back(found->second.result());
        table.rows.push_back(found->second.row());
    }
}

}  // namespace

Figure random_stacks_figure(const StudyRun& run) {
    Figure figure{
        "random-stacks", "Random stacks",
        fmt::format("Directional albedos of {} stacks of each kind, red, green and blue apart: "
                    "index 1 to 2.2, alpha 0 to 0.8, tau 0.3 to 1 for each coat; Lambertian bases "
                    "of albedo 0 to 1, conductors of eta 0.1 to 3, kappa 0.5 to 8 and alpha 0 to "
                    "0.8; cos_theta from 0.05. weidlich-wilkie and clearcoat shade one coat.",
                    kStacks),
        "mean and largest |error| of the directional albedo"};
    NumberTable table{"", error_columns("stacks", "model"), {}};
    for (const BaseKind kind : {BaseKind::conductor, BaseKind::lambertian})
        for (int coats = 1; coats <= kMostCoats; ++coats) add_kind(figure, table, kind, coats, run);
    figure.panels.emplace_back(std::move(table));
    return figure;
}

}  // namespace lacquer::study
