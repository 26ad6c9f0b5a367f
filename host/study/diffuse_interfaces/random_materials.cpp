// Albedos of random materials over the models' whole range.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "simulator/albedo.h"
#include "study/diffuse_interfaces/materials.h"
#include "study/diffuse_interfaces/suite.h"
#include "study/error_tally.h"
#include "study/material_pictures.h"

namespace lacquer::study {

namespace {

constexpr int kMaterials = 100;
constexpr std::uint64_t kMaterialShare = 1 << 5;
constexpr double kGrazing = 0.01;

struct Sample {
    Material material;
    double cos_theta;
};

// Uniform over [low, high], but every fourth at an end.
double uniform_or_end(std::mt19937_64& generator, double low, double high) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    const double choice = 8.0 * uniform(generator);
    if (choice < 1.0) return low;
    if (choice < 2.0) return high;
    return low + (high - low) * uniform(generator);
}

Sample random_sample(std::mt19937_64& generator) {
    const auto unit = [&] { return uniform_or_end(generator, 0.0, 1.0); };
    const double eta = std::pow(3.0, uniform_or_end(generator, -1.0, 1.0));
    const double alpha = unit();
    const Rgb tau{unit(), unit(), unit()};
    const Rgb albedo{unit(), unit(), unit()};
    return {coated(eta, alpha, albedo, tau), uniform_or_end(generator, kGrazing, 1.0)};
}

std::string describe(const Sample& sample, std::size_t channel) {
    const Layer& layer = sample.material.layers.front();
    return fmt::format(
        "eta {:.3f}, alpha {:.3f}, tau {:.3f}, albedo {:.3f}, cos_theta {:.3f}",
        layer.interface.ior, std::get<Microsurface>(layer.interface.roughness).alpha[0],
        std::get<AbsorbingMedium>(layer.medium).tau[channel],
        std::get<LambertianBase>(sample.material.base).albedo[channel], sample.cos_theta);
}

// Errors of one model.
struct Tallies {
    ErrorTally direct, base, total;
    std::vector<double> totals{};  // |errors|

    explicit Tallies(const std::string& model)
        : direct{"coat's albedo", model}, base{"base's albedo", model}, total{"total", model} {}

    void add(const Sample& sample, const reference::Albedo& model,
             const simulator::AlbedoEstimate& truth) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const int c = static_cast<int>(channel);
            const auto where = [&] { return describe(sample, channel); };
            const double direct_error = model.direct[c] - truth.direct.mean[channel];
            const double base_error = model.base[c] - truth.base.mean[channel];
            direct.add(direct_error, truth.direct.standard_error[channel], where);
            base.add(base_error, truth.base.standard_error[channel], where);
            total.add(direct_error + base_error, truth.total.standard_error[channel], where);
            totals.push_back(std::abs(direct_error + base_error));
        }
    }
};

// The share of errors below each size.
Curve distribution(const std::string& model, std::vector<double> errors, double least) {
    std::ranges::sort(errors);
    Curve curve{model};
    for (std::size_t n = 0; n < errors.size(); ++n) {
        curve.x.push_back(std::max(errors[n], least));
        curve.y.push_back(static_cast<double>(n + 1) / static_cast<double>(errors.size()));
    }
    return curve;
}

Plot distribution_plot(const std::vector<Tallies>& tallies) {
    Plot plot{"Share of materials below an error",
              "|error| of the total albedo",
              "share",
              1e-4,
              1.0,
              0.0,
              1.0};
    plot.x_logarithmic = true;
    const auto models = compared_models();
    for (std::size_t m = 0; m < models.size(); ++m)
        if (models[m] != Model::coated_ggx)
            plot.curves.push_back(
                distribution(std::string{model_name(models[m])}, tallies[m].totals, plot.x_from));
    return plot;
}

}  // namespace

Figure random_materials_figure(const StudyRun& run) {
    Figure figure{
        "random-materials", "Random materials over the whole range",
        fmt::format(
            "Directional albedos of {} materials and viewers, red, green and blue apart: eta "
            "from 1/3 to 3, alpha, tau and albedo from 0 to 1, cos_theta from 0.01, every "
            "fourth number at an end of its range. coated-ggx has the energies of "
            "coated-exact.",
            kMaterials),
        "mean and largest |error| of the directional albedo"};
    std::mt19937_64 generator{run.seed_of("random materials")};
    std::vector<Tallies> tallies;
    for (const Model model : compared_models())
        tallies.emplace_back(std::string{model_name(model)});
    for (int n = 0; n < kMaterials; ++n) {
        run.part(fmt::format("random material {}", n + 1));
        const Sample sample = random_sample(generator);
        const auto truth = simulator::estimate_albedo(
            simulator::StackWalk{sample.material}, sample.cos_theta,
            run.options(run.share(kMaterialShare), fmt::format("random {}", n)));
        const auto models = models_of(sample.material, compared_models());
        const glm::dvec3 wo{std::sqrt(1.0 - sample.cos_theta * sample.cos_theta), 0.0,
                            sample.cos_theta};
        tbb::parallel_for(std::size_t{0}, models.size(), [&](std::size_t m) {
            tallies[m].add(sample, models[m].albedo(wo), truth);
        });
    }
    for (const Tallies& tally : tallies)
        for (const ErrorTally* part : {&tally.direct, &tally.base, &tally.total})
            figure.errors.push_back(part->result());
    figure.panels.emplace_back(Plots{"", {distribution_plot(tallies)}});
    return figure;
}

}  // namespace lacquer::study
