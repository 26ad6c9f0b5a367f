#include "report/text.h"

#include <fmt/format.h>

#include "core/error.h"
#include "core/file.h"
#include "core/table.h"

namespace lacquer {

namespace {

std::string error_text(double error) {
    return fmt::format("{:.1e}", error);
}

bool measured(const BackendResult& backend) {
    return !backend.materials.empty();
}

std::vector<std::string> summary_row(const BackendResult& backend) {
    const std::string status{status_name(backend.status)};
    if (!measured(backend)) return {backend.name, status, "-", "-", "-", "-", backend.reason};
    return {backend.name,
            status,
            error_text(backend.max_rel()),
            error_text(backend.p999_rel()),
            error_text(backend.median_rel()),
            fmt::format("{:.1f}", backend.queries_per_second * 1e-6),
            backend.device};
}

std::uint64_t query_count(const BackendResult& backend) {
    std::uint64_t total = 0;
    for (const MaterialResult& material : backend.materials) total += material.errors.queries;
    return total;
}

}  // namespace

std::string summary_table(const CompareResult& result) {
    std::vector<std::vector<std::string>> rows;
    for (const BackendResult& backend : result.backends) rows.push_back(summary_row(backend));
    return format_table({{"backend"},
                         {"status"},
                         {"max rel", Align::right},
                         {"p99.9", Align::right},
                         {"median", Align::right},
                         {"Mq/s", Align::right},
                         {"device"}},
                        rows);
}

std::string accuracy_markdown(const CompareResult& result) {
    std::string table =
        "| backend | queries | max rel | p99.9 | median | device |\n"
        "| --- | ---: | ---: | ---: | ---: | --- |\n";
    for (const BackendResult& backend : result.backends)
        if (measured(backend))
            table +=
                fmt::format("| {} | {} | {} | {} | {} | {} |\n", backend.name, query_count(backend),
                            error_text(backend.max_rel()), error_text(backend.p999_rel()),
                            error_text(backend.median_rel()), backend.device);
    return table;
}

void update_markdown(const std::filesystem::path& file, const std::string& markdown) {
    std::string text = read_file(file);
    const std::size_t begin = text.find(kMarkdownBegin);
    const std::size_t end = begin == std::string::npos ? begin : text.find(kMarkdownEnd, begin);
    if (end == std::string::npos)
        throw Error{fmt::format("writing '{}': it lacks the lines '{}' and '{}'", file.string(),
                                kMarkdownBegin, kMarkdownEnd)};
    const std::size_t first = begin + kMarkdownBegin.size();
    text.replace(first, end - first, "\n" + markdown);
    write_file(file, text);
}

}  // namespace lacquer
