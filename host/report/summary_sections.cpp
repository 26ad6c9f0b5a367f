// The report's overview: backends, the matrix of materials and backends, all errors' distribution.
#include <fmt/format.h>

#include <cmath>

#include "report/histogram.h"
#include "markup/markup.h"
#include "report/sections.h"

namespace lacquer {

namespace {

constexpr int kThumbnailShrink = 2;
constexpr int kThumbnailSize = 44;

std::string number_cell(double error) {
    return fmt::format(R"(<td class="num">{}</td>)", error_html(error));
}

std::string margin_cell(double error, double limit) {
    return fmt::format(R"(<td class="num margin{}" style="{}">{}</td>)",
                       error <= limit ? "" : " over", margin_style(error, limit),
                       error_html(error));
}

std::string backend_row(const BackendResult& backend) {
    const std::string head = fmt::format("<tr><th>{}</th><td>{}</td>", escaped(backend.name),
                                         status_pill(backend.status));
    if (backend.materials.empty())
        return head + fmt::format(R"(<td colspan="5" class="reason">{}</td></tr>)",
                                  escaped(backend.reason));
    return head + margin_cell(backend.max_rel(), backend.tolerance.max_rel) +
           number_cell(backend.p999_rel()) +
           margin_cell(backend.median_rel(), backend.tolerance.median_rel) +
           fmt::format(R"(<td class="num">{:.1f}</td><td>{}</td></tr>)",
                       backend.queries_per_second * 1e-6, escaped(backend.device));
}

std::string matrix_cell(const CompareResult& result, const BackendResult& backend,
                        std::size_t material) {
    if (backend.materials.empty()) return R"(<td class="num none">–</td>)";
    const MaterialResult& cell = backend.materials[material];
    return fmt::format(
        R"(<td class="num margin{}" style="{}" )"
        R"(title="{} on {}: median {:.1e}, p99.9 {:.1e}">{}</td>)",
        cell.passed ? "" : " over", margin_style(cell.errors.max_rel, backend.tolerance.max_rel),
        escaped(backend.name), escaped(result.materials[material].material.name),
        cell.errors.median_rel, cell.errors.p999_rel, error_html(cell.errors.max_rel));
}

std::string matrix_row(const CompareResult& result, std::size_t index) {
    const NamedMaterial& material = result.materials[index];
    std::string row = fmt::format(
        R"(<tr><th><a href="#{}">{}<span>{}</span></a></th>)", material_anchor(material),
        image_html("thumb", reference_sphere_png(result, index, kThumbnailShrink), kThumbnailSize,
                   kThumbnailSize, ""),
        escaped(material.material.name));
    for (const BackendResult& backend : result.backends) row += matrix_cell(result, backend, index);
    return row + "</tr>\n";
}

}  // namespace

std::string backends_section(const CompareResult& result) {
    std::string rows;
    for (const BackendResult& backend : result.backends) rows += backend_row(backend) + "\n";
    return fmt::format(
        R"(<section><h2>Backends</h2>
<p>Largest errors over all materials. Throughput is that of this machine, moving data included.</p>
<div class="scroll"><table class="backends"><thead><tr><th>backend</th><th>status</th>
<th class="num">max rel</th><th class="num">p99.9</th><th class="num">median</th>
<th class="num">Mq/s</th><th>device</th></tr></thead><tbody>
{}</tbody></table></div></section>
)",
        rows);
}

std::string matrix_section(const CompareResult& result) {
    std::string heads, rows;
    for (const BackendResult& backend : result.backends)
        heads += fmt::format(R"(<th class="num">{}</th>)", escaped(backend.name));
    for (std::size_t i = 0; i < result.materials.size(); ++i) rows += matrix_row(result, i);
    return fmt::format(
        R"(<section><h2>Maximum relative error</h2>
<p>Each material in each language; colours show the margin to the tolerance.</p>
<p class="key"><span><i style="--hue:155"></i>a hundredth of it or less</span>
<span><i style="--hue:100"></i>a tenth</span> <span><i style="--hue:45"></i>all of it</span>
<span><i class="over"></i>past it</span></p>
<div class="scroll"><table class="matrix"><thead><tr><th></th>{}</tr></thead><tbody>
{}</tbody></table></div></section>
)",
        heads, rows);
}

std::string distribution_section(const CompareResult& result) {
    std::vector<NamedHistogram> histograms;
    for (const BackendResult& backend : result.backends) {
        if (backend.materials.empty()) continue;
        NamedHistogram named{backend.name, {}};
        for (const MaterialResult& material : backend.materials) named.histogram.add(material);
        histograms.push_back(std::move(named));
    }
    if (histograms.empty()) return {};
    return fmt::format(
        R"(<section><h2>Distribution of errors</h2>
<p>Share of all queries per eighth of a decade. Rounding to float alone is 6e-8.</p>
{}</section>
)",
        histogram_chart(histograms, result.backends.front().tolerance));
}

}  // namespace lacquer
