#include "report/html.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>

#include <algorithm>
#include <ctime>
#include <fstream>

#include "core/error.h"
#include "core/version.h"
#include "markup/markup.h"
#include "report/sections.h"
#include "report/style.h"

namespace lacquer {

namespace {

std::string processor_name() {
    std::ifstream file{"/proc/cpuinfo"};
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name") && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return "unknown processor";
}

std::size_t count_status(const CompareResult& result, Status status) {
    return static_cast<std::size_t>(
        std::count_if(result.backends.begin(), result.backends.end(),
                      [status](const BackendResult& b) { return b.status == status; }));
}

std::uint64_t query_count(const CompareResult& result) {
    std::uint64_t queries = 0;
    for (const QueryGrid& grid : result.grids) queries += grid.query_count();
    return queries * result.materials.size();
}

std::string failed_names(const CompareResult& result) {
    std::string names;
    for (const BackendResult& backend : result.backends)
        if (backend.status == Status::failed)
            names += (names.empty() ? "" : ", ") + escaped(backend.name);
    return names;
}

std::string verdict(const CompareResult& result) {
    const std::size_t failed = count_status(result, Status::failed);
    const std::size_t ran = result.backends.size() - count_status(result, Status::skipped);
    if (ran == 0) return "No backend could run here.";
    if (failed == 0)
        return fmt::format("{} of {} backends ran; all of them are within tolerance.", ran,
                           result.backends.size());
    return fmt::format("{} of the {} backends that ran failed: {}.", failed, ran,
                       failed_names(result));
}

std::string fact(std::string_view value, std::string_view meaning) {
    return fmt::format("<div><b>{}</b><span>{}</span></div>", value, meaning);
}

std::string facts(const CompareResult& result) {
    double most = 0.0;
    for (const BackendResult& backend : result.backends) most = std::max(most, backend.max_rel());
    return fact(fmt::format("{}", result.materials.size()), "materials") +
           fact(fmt::format("{:.2f} million", double(query_count(result)) * 1e-6),
                "queries per backend") +
           fact(error_html(most), "largest relative error") +
           fact(error_html(kFloatTolerance.max_rel), "allowed");
}

std::string gallery(const CompareResult& result) {
    constexpr int kShrink = 2;
    constexpr int kSize = 128;
    std::string spheres;
    for (std::size_t i = 0; i < result.materials.size(); ++i)
        spheres += fmt::format(R"(<a href="#{}">{}</a>)", material_anchor(result.materials[i]),
                               image_html("", reference_sphere_png(result, i, kShrink), kSize,
                                          kSize, result.materials[i].material.name));
    return fmt::format(R"(<nav class="gallery">{}</nav>)", spheres);
}

std::string header_html(const CompareResult& result) {
    return fmt::format(
        R"(<header><p class="brand">Lacquer {}</p><h1>One source, every language</h1>
<p class="verdict {}">{}</p>
<div class="facts">{}</div>{}</header>
)",
        escaped(kVersion), count_status(result, Status::failed) > 0 ? "failed" : "passed",
        verdict(result), facts(result), gallery(result));
}

std::string method_html(const CompareResult& result, const ReportEnvironment& environment) {
    return fmt::format(
        R"(<section class="method"><h2>How this was measured</h2>
<p>Each backend executes the shaders generated from one source. The reference computes the model
<code>{}</code> in double precision, from code that shares nothing with that source, for the same
directions rounded to float. Slices show all light directions for one viewer (Lambert's equal-area
projection); spheres are lit by one directional light of irradiance π, which makes their radiance
π f cos θ<sub>i</sub>. A query's error is the
largest over its colour channels and, in slices, its sampling density; relative errors are
|e| / max(|reference|, {:g}).</p>
<dl class="environment"><dt>suite</dt><dd>{}</dd><dt>reference</dt><dd>{}, {:.1f} Mq/s</dd>
<dt>processor</dt><dd>{}</dd><dt>system</dt><dd>{}</dd><dt>date</dt><dd>{}</dd></dl></section>
)",
        model_name(result.model), kRelativeFloor, escaped(result.suite),
        escaped(result.reference_device), result.reference_queries_per_second * 1e-6,
        escaped(environment.processor), escaped(environment.system), escaped(environment.date));
}

}  // namespace

ReportEnvironment current_environment() {
    utsname system{};
    ::uname(&system);
    return {.processor = processor_name(),
            .system = fmt::format("{} {} {}", system.sysname, system.release, system.machine),
            .date = fmt::format("{:%Y-%m-%d %H:%M} UTC", fmt::gmtime(std::time(nullptr)))};
}

std::string report_html(const CompareResult& result, const ReportEnvironment& environment) {
    if (result.reference_values.size() != result.materials.size())
        throw Error{"writing the report: the comparison kept no values to draw pictures from"};
    std::string materials;
    for (std::size_t i = 0; i < result.materials.size(); ++i)
        materials += material_section(result, i);
    return fmt::format(
        R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Lacquer: backends against the reference</title><style>{}</style></head><body>
{}<main>{}{}{}<section class="intro"><h2>Materials</h2></section>
{}{}</main></body></html>
)",
        kReportStyle, header_html(result), backends_section(result), matrix_section(result),
        distribution_section(result), materials, method_html(result, environment));
}

}  // namespace lacquer
