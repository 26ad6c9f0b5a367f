#include "study/heightfields/surface_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "heightfield/relief_picture.h"
#include "simulator/slice_picture.h"
#include "study/error_tally.h"

namespace lacquer::study {

namespace {

using heightfield::MaterialLight;
using heightfield::OrderLight;
using heightfield::ScatteredLight;
using simulator::FacetStratum;
using simulator::RgbEstimate;
using simulator::SlicePicture;

constexpr double kPi = std::numbers::pi;

// Differences of radiance up to this have colours.
constexpr double kDifferenceLimit = 0.2;

// Of the surface in its picture and its cut, in correlation lengths.
constexpr double kPictureLengths = 10.0, kProfileLengths = 24.0;

constexpr const char* kTheory = "Smith's theory";

double mean_of(const Rgb& rgb) {
    return (rgb[0] + rgb[1] + rgb[2]) / 3.0;
}

std::string order_name(const ScatteredLight& light, std::size_t order) {
    return order + 1 < light.orders.size() ? fmt::format("order {}", order + 1) : "higher orders";
}

std::string theta_name(double theta) {
    return fmt::format("theta {:.4g}", theta);
}

// Radiance per pixel of an order, or of all orders where it is one beyond the last.
std::vector<glm::dvec3> radiance_of(const ScatteredLight& light, std::size_t order) {
    std::vector<glm::dvec3> radiance(light.orders.front().pixels.size(), glm::dvec3{0.0});
    const bool all = order == light.orders.size();
    for (std::size_t one = 0; one < light.orders.size(); ++one) {
        if (!all && one != order) continue;
        for (std::size_t pixel = 0; pixel < radiance.size(); ++pixel) {
            const Rgb& f = light.orders[one].pixels[pixel].mean;
            radiance[pixel] += kPi * glm::dvec3{f[0], f[1], f[2]};
        }
    }
    return radiance;
}

template <typename Value>
Image paint_disk(int size, const Value& value) {
    const SlicePicture disk{size};
    Image image{size, size};
    for (const std::size_t pixel : disk.visible_pixels())
        image.pixels[pixel] = glm::vec4{glm::vec3{value(pixel)}, 1.0f};
    return image;
}

// One column of the pictures of a direction: traced, walked, and the difference.
void add_column(PictureTable& table, const MaterialLight& light, std::size_t n, std::size_t order) {
    const ScatteredLight& traced = light.traced[n];
    const bool all = order == traced.orders.size();
    table.columns.push_back(all ? "all" : order_name(traced, order));
    const std::string prefix = fmt::format("theta_{:.4g}_{}", light.thetas[n],
                                           all ? "all" : fmt::format("order_{}", order + 1));
    const auto truth = radiance_of(traced, order), theory = radiance_of(light.walked[n], order);
    const int size = light.options.picture_size;
    table.rows[0].pictures.push_back(
        {prefix + "_heightfield", paint_disk(size, [&](std::size_t p) { return truth[p]; })});
    table.rows[1].pictures.push_back(
        {prefix + "_smith", paint_disk(size, [&](std::size_t p) { return theory[p]; })});
    const auto difference = [&](std::size_t p) {
        const glm::dvec3 d = theory[p] - truth[p];
        return glm::dvec3{(d.x + d.y + d.z) / 3.0};
    };
    table.rows[2].pictures.push_back(
        {prefix + "_difference", paint_disk(size, difference), kDifferenceLimit});
}

PictureTable light_pictures(const MaterialLight& light, std::size_t n) {
    PictureTable table{fmt::format("Light from {}", theta_name(light.thetas[n])),
                       {},
                       {{"heightfield", {}}, {"Smith", {}}, {"difference", {}}}};
    for (std::size_t order = 0; order <= light.traced[n].orders.size(); ++order)
        add_column(table, light, n, order);
    return table;
}

std::vector<std::string> energy_row(const std::string& theta, const std::string& what,
                                    const RgbEstimate& traced, const RgbEstimate& walked) {
    const double found = mean_of(traced.mean), theory = mean_of(walked.mean);
    return {theta,
            what,
            fmt::format("{:.4f}", found),
            fmt::format("{:.4f}", mean_of(traced.standard_error)),
            fmt::format("{:.4f}", theory),
            fmt::format("{:.4f}", mean_of(walked.standard_error)),
            fmt::format("{:+.4f}", theory - found)};
}

// Standard normal colours of metals and dyes; dielectrics are white. Strata of one material are
// told apart by a tint.
Rgb color_of(const simulator::FacetMaterial& material) {
    if (const auto* conductor = std::get_if<simulator::ConductorFacet>(&material)) {
        const simulator::Vec3 f = simulator::conductor_reflectance(1.0, *conductor);
        return {f.x, f.y, f.z};
    }
    if (const auto* diffuse = std::get_if<simulator::DiffuseFacet>(&material))
        return diffuse->albedo;
    return {1.0, 1.0, 1.0};
}

std::vector<Rgb> colors_of(const std::vector<FacetStratum>& strata) {
    constexpr Rgb kTint{0.55, 0.75, 1.0};
    std::vector<Rgb> colors;
    for (const FacetStratum& stratum : strata) colors.push_back(color_of(stratum.material));
    const bool one_color =
        std::ranges::all_of(colors, [&](const Rgb& color) { return color == colors.front(); });
    for (std::size_t n = 1; one_color && n < colors.size(); n += 2)
        for (std::size_t channel = 0; channel < 3; ++channel) colors[n][channel] *= kTint[channel];
    return colors;
}

Plots profile_plot(const heightfield::Heightfield& surface, const MaterialLight& light) {
    constexpr int kPoints = 1200;
    const double length = light.grid.cells_per_length;
    const double extent = std::min(kProfileLengths, light.grid.period_lengths()) * length;
    Curve curve{"height", {}, {}};
    for (const glm::dvec2& point : relief_profile(surface, extent, kPoints)) {
        curve.x.push_back(point.x / length);
        curve.y.push_back(point.y / length);
    }
    const auto [low, high] = std::ranges::minmax(curve.y);
    const double margin = std::max(0.1 * (high - low), 0.1);
    return {"",
            {{"A cut along x",
              "x in correlation lengths",
              "height",
              0.0,
              extent / length,
              low - margin,
              high + margin,
              {curve}}}};
}

void add_surface(Figure& figure, const MaterialLight& light) {
    const heightfield::Heightfield surface{light.surface.strata, light.grid, light.options.seed, 0};
    heightfield::ReliefView view;
    view.extent =
        std::min(kPictureLengths, light.grid.period_lengths()) * light.grid.cells_per_length;
    PictureTable table{
        "The first of the surfaces",
        {"seen at a slant"},
        {{"", {{"surface", relief_picture(surface, colors_of(light.surface.strata), view)}}}}};
    table.column_width = view.width;
    figure.panels.emplace_back(std::move(table));
    figure.panels.emplace_back(profile_plot(surface, light));
}

void add_energies(Figure& figure, const MaterialLight& light) {
    NumberTable table{"Energy, mean over the channels",
                      {"theta", "light", "heightfield", "standard error", "Smith", "standard error",
                       "difference"},
                      {}};
    for (std::size_t n = 0; n < light.thetas.size(); ++n) {
        const ScatteredLight &traced = light.traced[n], &walked = light.walked[n];
        const std::string theta = fmt::format("{:.4g}", light.thetas[n]);
        ErrorTally tally{theta_name(light.thetas[n]), kTheory};
        for (std::size_t order = 0; order < traced.orders.size(); ++order) {
            const RgbEstimate &truth = traced.orders[order].energy,
                              &theory = walked.orders[order].energy;
            const std::string name = order_name(traced, order);
            table.rows.push_back(energy_row(theta, name, truth, theory));
            tally.add(mean_of(theory.mean) - mean_of(truth.mean),
                      std::hypot(mean_of(truth.standard_error), mean_of(theory.standard_error)),
                      [&] { return name; });
        }
        table.rows.push_back(energy_row(theta, "reflected", traced.reflected, walked.reflected));
        if (mean_of(traced.transmitted.mean) + mean_of(walked.transmitted.mean) > 0.0)
            table.rows.push_back(
                energy_row(theta, "transmitted", traced.transmitted, walked.transmitted));
        figure.errors.push_back(tally.result());
    }
    figure.panels.emplace_back(std::move(table));
}

}  // namespace

Figure surface_figure(const MaterialLight& light) {
    Figure figure{"surface", light.material.name,
                  fmt::format("{} surfaces of {} x {} cells, {} to a correlation length, {} rays "
                              "on each.",
                              light.options.repetitions, light.grid.cells, light.grid.cells,
                              light.grid.cells_per_length, light.options.rays),
                  "|energy| of an order, of all that arrives"};
    add_surface(figure, light);
    add_energies(figure, light);
    for (std::size_t n = 0; n < light.thetas.size(); ++n)
        figure.panels.emplace_back(light_pictures(light, n));
    return figure;
}

}  // namespace lacquer::study
