#include "study/summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/table.h"
#include "study/errors.h"

namespace lacquer::study {

std::vector<std::string> common_models(const StudyResult& result) {
    std::vector<std::pair<std::string, int>> counts;
    for (const Figure& figure : result.figures)
        for (const std::string& model : error_models(figure)) {
            const auto found =
                std::ranges::find(counts, model, &std::pair<std::string, int>::first);
            if (found == counts.end())
                counts.emplace_back(model, 1);
            else
                ++found->second;
        }
    const bool only_figure = result.figures.size() == 1;
    std::vector<std::string> models;
    for (const auto& [model, count] : counts)
        if (count > 1 || only_figure) models.push_back(model);
    return models;
}

std::string summary_text(const StudyResult& result) {
    std::vector<std::vector<std::string>> rows;
    for (const Figure& figure : result.figures)
        for (const std::string& model : error_models(figure)) {
            const ModelError error = *overall_error(figure, model);
            rows.push_back({figure.id, model, fmt::format("{:.4f}", error.mean),
                            fmt::format("{:.4f}", error.noise), fmt::format("{:.4f}", error.max),
                            fmt::format("{}: {}", error.subject, error.where)});
        }
    return format_table({{"figure"},
                         {"model"},
                         {"mean error", Align::right},
                         {"noise", Align::right},
                         {"max", Align::right},
                         {"largest at"}},
                        rows);
}

}  // namespace lacquer::study
