// Figure 5: T01 from fewer basis functions than the shipped tables keep.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>

#include "bake/accuracy.h"
#include "bake/truncation.h"
#include "core/paths.h"
#include "reference/coated.h"
#include "study/coat_light.h"
#include "study/diffuse_interfaces/materials.h"
#include "study/diffuse_interfaces/suite.h"
#include "study/error_tally.h"
#include "study/material_pictures.h"
#include "tables/polynomial.h"

namespace lacquer::study {

namespace {

using reference::BaseLobe;
using reference::CoatedSurface;
using Tables = std::array<Table, kTableNames.size()>;

constexpr int kPoints = 256;
constexpr std::uint64_t kPointShare = 1 << 10;  // half the walks of a point, a power of two

// The tables with both of T01 cut down to so many functions.
EnergyTables truncated(const Tables& tables, std::size_t absorptions, std::size_t polynomials) {
    Tables changed = tables;
    changed[0] = bake::truncated(tables[0], Contrast::thin, absorptions, polynomials);
    changed[1] = bake::truncated(tables[1], Contrast::dense, absorptions, polynomials);
    return EnergyTables{changed};
}

// T01 at random points of its whole range.
struct Points {
    bake::Check check;
    std::vector<bake::Parameters> at;
    std::vector<double> truth, errors;  // standard errors
};

Points simulated_points(const StudyRun& run) {
    Points points{
        bake::all_checks().front(), {}, std::vector<double>(kPoints), std::vector<double>(kPoints)};
    std::mt19937_64 generator{run.seed_of("compression")};
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int n = 0; n < kPoints; ++n) {
        const double cosine = uniform(generator), alpha = uniform(generator);
        const double eta = std::pow(3.0, 2.0 * uniform(generator) - 1.0), tau = uniform(generator);
        points.at.push_back({cosine, alpha, eta, tau});
    }
    const bake::SobolPoints sequence{std::bit_floor(run.share(kPointShare))};
    tbb::parallel_for(std::size_t{0}, points.at.size(), [&](std::size_t n) {
        const std::uint64_t seed = run.seed_of(fmt::format("compression {}", n));
        const double one = points.check.simulate(points.at[n], sequence, seed);
        const double other = points.check.simulate(points.at[n], sequence, bake::mix_bits(seed));
        points.truth[n] = 0.5 * (one + other);
        points.errors[n] = 0.5 * std::abs(one - other);
    });
    return points;
}

ModelError point_error(const Points& points, const EnergyTables& tables, const std::string& subject,
                       const std::string& name) {
    ErrorTally tally{subject, name};
    for (std::size_t n = 0; n < points.at.size(); ++n) {
        const bake::Parameters& at = points.at[n];
        tally.add(points.check.look_up(tables, at) - points.truth[n], points.errors[n], [&] {
            return fmt::format("cos_theta {:.3f}, alpha {:.3f}, eta {:.3f}, tau {:.3f}", at[0],
                               at[1], at[2], at[3]);
        });
    }
    return tally.result();
}

std::string functions_of_tau(std::size_t count) {
    return fmt::format("{} function{} of tau", count, count == 1 ? "" : "s");
}

// Mean and largest error by the number of functions kept, logarithmic.
Plot error_plot(const std::string& title, const std::vector<ModelError>& errors) {
    Plot plot{title, "functions kept", "|error| of T01", 0.0, errors.size() > 5 ? 10.0 : 5.0, 1e-4,
              1.0};
    plot.y_logarithmic = true;
    Curve mean{"mean"}, max{"max"};
    for (std::size_t n = 0; n < errors.size(); ++n) {
        mean.x.push_back(double(n + 1));
        mean.y.push_back(errors[n].mean);
        max.x.push_back(double(n + 1));
        max.y.push_back(errors[n].max);
    }
    plot.curves = {mean, max};
    return plot;
}

void add_table_errors(const Tables& tables, const StudyRun& run, Figure& figure) {
    run.part("compression of T01");
    const Points points = simulated_points(run);
    std::vector<ModelError> by_tau, by_cosine;
    for (std::size_t n = 1; n <= kAbsorptions; ++n)
        by_tau.push_back(
            point_error(points, truncated(tables, n, kCoefficients), "T01", functions_of_tau(n)));
    for (std::size_t n = 1; n <= kCoefficients; ++n)
        by_cosine.push_back(
            point_error(points, truncated(tables, kAbsorptions, n), "T01", "polynomials"));
    figure.errors.insert(figure.errors.end(), by_tau.rbegin(), by_tau.rend());
    figure.panels.emplace_back(
        Plots{fmt::format("T01 at {} random points against fresh simulation", kPoints),
              {error_plot("By functions of tau", by_tau),
               error_plot("By polynomials of cos_theta", by_cosine)}});
}

// coated-exact from tables with fewer functions.
class TruncatedShading final : public reference::Shading {
 public:
    explicit TruncatedShading(CoatedSurface surface) : surface_{std::move(surface)} {}

    glm::dvec3 eval(const glm::dvec3& wi, const glm::dvec3& wo) const override {
        return reference::eval(surface_, wi, wo);
    }
    double pdf(const glm::dvec3& wi, const glm::dvec3& wo) const override {
        return reference::pdf(surface_, wi, wo);
    }
    reference::Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const override {
        return reference::sample(surface_, wo, u);
    }
    reference::Albedo albedo(const glm::dvec3& wo) const override {
        return reference::albedo(surface_, wo);
    }

 private:
    CoatedSurface surface_;
};

// What each variant loses against the first.
PictureTable losses(const Material& material, const View& view,
                    std::span<const ModelLight> variants) {
    constexpr double kLimit = 0.02;
    PictureTable table{
        "less the picture of all functions, on a finer scale", {}, {{"difference", {}}}};
    const Radiance all = shade(view, variants.front());
    for (const ModelLight& variant : variants.subspan(1)) {
        table.columns.push_back(variant.name());
        table.rows.front().pictures.push_back(
            difference_picture(view, shade(view, variant), all, kLimit,
                               picture_name(material, view, variant.name() + " loss")));
    }
    return table;
}

void add_spheres(const Tables& tables, const Material& material, const StudyRun& run,
                 Figure& figure) {
    std::vector<ModelLight> variants;
    for (std::size_t n = kAbsorptions; n >= 1; --n)
        variants.emplace_back(functions_of_tau(n),
                              std::make_shared<TruncatedShading>(reference::prepare_coated(
                                  material, truncated(tables, n, kCoefficients), BaseLobe::exact)));
    const std::array views{sphere_view()};
    const std::array truth{simulate(views[0], material, run)};
    add_material(figure, material, views, truth, variants);
    figure.panels.emplace_back(losses(material, views[0], variants));
    for (const ModelLight& model : models_of(material, compared_models()))
        figure.errors.push_back(picture_error(views[0], shade(views[0], model), truth[0],
                                              picture_subject(material, views[0]), model.name()));
}

}  // namespace

Figure compression_figure(const StudyRun& run) {
    Figure figure{
        "figure-5", "Figure 5: compression",
        "The shipped tables write T01 as 5 functions of tau, each with 8 or fewer polynomials of "
        "cos_theta to either side of the critical angle, over alpha and eta; the paper as 2 "
        "functions "
        "of tau and 4 of eta. Kept here: the first 1 to 5 functions of tau. One function alone has "
        "one hue for all absorptions; from 3 on no difference is seen. What is off at eta 0.8 with "
        "all of "
        "them is the model, see figure 7. The models in the table are "
        "those of the shipped tables.",
        "T01: mean and largest |error|; pictures: mean |difference| of the pixels over their mean, "
        "and the largest in radiance beyond three standard errors"};
    const Tables tables = read_tables(share_folder() / "tables");
    add_table_errors(tables, run, figure);
    const Rgb albedo{0.9, 0.9, 0.9}, tau{0.95, 0.6, 0.25};
    for (const double eta : {0.8, 1.5})
        add_spheres(tables, coated(eta, 0.2, albedo, tau), run, figure);
    return figure;
}

}  // namespace lacquer::study
