// The report's card of one material: spheres, heat maps, distributions, slices, worst queries.
#include <fmt/format.h>

#include <cmath>

#include "image/png.h"
#include "report/heat.h"
#include "report/histogram.h"
#include "markup/markup.h"
#include "report/sections.h"

namespace lacquer {

namespace {

std::vector<std::size_t> grids_of(const CompareResult& result, Kernel kernel) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < result.grids.size(); ++i)
        if (result.grids[i].kernel == kernel) indices.push_back(i);
    return indices;
}

std::string picture_png(const QueryGrid& grid, const GridValues& values) {
    const Image image = picture(grid, values);
    return encode_png(image.width, image.height, display_pixels(image));
}

std::string heat_html(const CompareResult& result, const BackendResult& backend,
                      const MaterialResult& material, std::span<const std::size_t> grids,
                      std::string_view kind) {
    std::vector<HeatTile> tiles;
    for (const std::size_t g : grids)
        tiles.push_back({&result.grids[g], material.values[g].relative_errors});
    if (tiles.empty()) return {};
    const QueryGrid& first = *tiles.front().grid;
    return image_html(kind, heat_png(HeatScale{backend.tolerance.max_rel}, tiles),
                      first.width * static_cast<int>(tiles.size()), first.height,
                      fmt::format("relative error of {}", backend.name));
}

std::string sphere_html(const CompareResult& result, const std::vector<GridValues>& values,
                        std::string_view whose) {
    std::string html;
    for (const std::size_t g : grids_of(result, Kernel::sphere))
        html += image_html("sphere", picture_png(result.grids[g], values[g]), result.grids[g].width,
                           result.grids[g].height, fmt::format("sphere by {}", whose));
    return html;
}

// "10^-4" or "2.5 10^-4".
std::string tick_html(double value) {
    const double power = std::floor(std::log10(value) + 1e-9);
    const double mantissa = value / std::pow(10.0, power);
    const std::string factor = mantissa < 1.05 ? "" : fmt::format("{:.2g}·", mantissa);
    return fmt::format("{}10<sup>{}</sup>", factor, power);
}

std::string heat_legend(const HeatScale& scale) {
    std::string stops, labels;
    for (int step = 0; step < HeatScale::kSteps; ++step) {
        const DisplayColor& color = scale.palette()[HeatScale::kFirstStep + step];
        stops += fmt::format("{}rgb({} {} {})", step == 0 ? "" : ",", color.r, color.g, color.b);
    }
    for (int decade = -HeatScale::kDecades; decade <= 0; ++decade)
        labels += fmt::format("<span>{}</span>", tick_html(scale.limit() * std::pow(10.0, decade)));
    return fmt::format(
        R"html(<div class="heat-legend"><b>relative error</b>
<div class="ramp" style="background:linear-gradient(90deg,{})"></div><div class="ticks">{}</div>
<div><i class="past"></i>past the limit</div><div><i class="nan"></i>not finite</div></div>)html",
        stops, labels);
}

std::string reference_tile(const CompareResult& result, std::size_t index) {
    return fmt::format(R"(<article class="tile"><h4>reference</h4>{}{}</article>)",
                       sphere_html(result, result.reference_values[index], "the reference"),
                       heat_legend(HeatScale{result.backends.front().tolerance.max_rel}));
}

std::string figures_html(const ErrorSummary& errors) {
    return fmt::format(
        "<dl><dt>max</dt><dd>{}</dd><dt>p99.9</dt><dd>{}</dd><dt>median</dt><dd>{}</dd></dl>",
        error_html(errors.max_rel), error_html(errors.p999_rel), error_html(errors.median_rel));
}

std::string backend_tile(const CompareResult& result, const BackendResult& backend,
                         const MaterialResult& material) {
    ErrorHistogram histogram;
    histogram.add(material);
    const std::vector<std::size_t> spheres = grids_of(result, Kernel::sphere);
    return fmt::format(
        R"(<article class="tile{}"><h4>{}</h4>{}{}{}{}</article>)", material.passed ? "" : " over",
        escaped(backend.name), sphere_html(result, material.values, backend.name),
        heat_html(result, backend, material, spheres, "heat"),
        histogram_sparkline(histogram, backend.tolerance), figures_html(material.errors));
}

std::string slice_labels(const CompareResult& result) {
    std::string labels;
    for (const std::size_t g : grids_of(result, Kernel::slice))
        labels += fmt::format("<span>{}°</span>", escaped(result.grids[g].name.substr(6)));
    return fmt::format(R"(<div class="strip-labels">{}</div>)", labels);
}

std::string reference_strip(const CompareResult& result, std::size_t index) {
    std::string pictures;
    for (const std::size_t g : grids_of(result, Kernel::slice))
        pictures +=
            image_html("slice", picture_png(result.grids[g], result.reference_values[index][g]),
                       result.grids[g].width, result.grids[g].height,
                       fmt::format("{} by the reference", result.grids[g].name));
    return fmt::format(R"(<div class="strip">{}</div>)", pictures);
}

std::string worst_html(const BackendResult& backend, const MaterialResult& material) {
    const WorstQuery& worst = material.worst;
    return fmt::format(
        R"(<p>Worst query, in {}: {} is {:.9g}, the reference has {:.9g}.</p><pre>{}</pre>)",
        escaped(worst.grid), worst.component, worst.value, worst.reference,
        escaped(replay_command(backend, material)));
}

// Per backend the errors over the slices and the worst query; open where something failed.
std::string details_html(const CompareResult& result, std::size_t index) {
    const std::vector<std::size_t> slices = grids_of(result, Kernel::slice);
    std::string rows;
    bool failed = false;
    for (const BackendResult& backend : result.backends) {
        if (backend.materials.empty()) continue;
        const MaterialResult& material = backend.materials[index];
        failed = failed || !material.passed;
        rows +=
            fmt::format(R"(<div class="detail"><h4>{} {}</h4>{}{}</div>)", escaped(backend.name),
                        material.passed ? "" : status_pill(Status::failed),
                        heat_html(result, backend, material, slices, "heat-strip"),
                        worst_html(backend, material));
    }
    return fmt::format(
        "<details{}><summary>Errors over the slices, and worst queries</summary>{}</details>",
        failed ? " open" : "", rows);
}

}  // namespace

std::string material_section(const CompareResult& result, std::size_t index) {
    const NamedMaterial& material = result.materials[index];
    std::string tiles = reference_tile(result, index);
    int count = 1;
    for (const BackendResult& backend : result.backends) {
        if (backend.materials.empty()) continue;
        tiles += backend_tile(result, backend, backend.materials[index]);
        ++count;
    }
    return fmt::format(
        R"(<section class="card" id="{}"><h3>{} <code>{}</code></h3>
<div class="tiles" style="--count: {}">{}</div>
<h4 class="strip-title">Slices by the reference: all light directions, for a viewer at these
angles from the normal</h4>
{}{}{}</section>
)",
        material_anchor(material), escaped(material.material.name), escaped(material.name), count,
        tiles, slice_labels(result), reference_strip(result, index), details_html(result, index));
}

}  // namespace lacquer
