#include "study/page.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/version.h"
#include "markup/markup.h"
#include "markup/plot.h"
#include "report/html.h"
#include "report/style.h"
#include "study/errors.h"
#include "study/panels.h"
#include "study/style.h"
#include "study/summary.h"

namespace lacquer::study {

namespace {

std::string fact(std::string_view value, std::string_view meaning) {
    return fmt::format("<div><b>{}</b><span>{}</span></div>", value, meaning);
}

std::string contents(const StudyResult& result) {
    std::string links;
    for (const Figure& figure : result.figures)
        links += fmt::format(R"(<a href="#{}">{}</a>)", figure.id, escaped(figure.title));
    return fmt::format(R"(<nav class="contents">{}</nav>)", links);
}

std::string header_html(const StudyResult& result) {
    const Suite& suite = *result.suite;
    return fmt::format(
        R"(<header><p class="brand">Lacquer {}</p><h1>{}</h1><p class="paper">{}</p>
<div class="facts">{}{}{}</div>{}</header>
)",
        escaped(kVersion), escaped(suite.title), escaped(suite.paper),
        fact(std::to_string(result.figures.size()), "figures"),
        fact(fmt::format("{:.3g} million", double(result.samples) * 1e-6), "walks per picture"),
        fact(fmt::format("{:.0f} s", result.seconds), "to compute"), contents(result));
}

std::string overview_html(const StudyResult& result) {
    const std::vector<std::string> models = common_models(result);
    std::string head = "<th>figure</th>", rows;
    for (const std::string& model : models)
        head += fmt::format(R"(<th class="num">{}</th>)", escaped(model));
    for (const Figure& figure : result.figures) {
        rows +=
            fmt::format(R"(<tr><th><a href="#{}">{}</a></th>)", figure.id, escaped(figure.title));
        for (const std::string& model : models) {
            const auto error = overall_error(figure, model);
            rows += error ? error_cell(error->mean, {},
                                       fmt::format("at worst {:.3g}, {}: {}", error->max,
                                                   error->subject, error->where))
                          : R"(<td class="num none">–</td>)";
        }
        rows += "</tr>\n";
    }
    return fmt::format(
        R"(<section><h2>How far each model is from the light</h2>
<p>{} Each number is the mean error over all parts of a figure, in the figure's own measure.</p>
<div class="scroll"><table class="errors"><thead><tr>{}</tr></thead><tbody>
{}</tbody></table></div></section>
)",
        escaped(result.suite->summary), head, rows);
}

std::string figure_html(const Figure& figure) {
    std::string panels;
    for (const Panel& panel : figure.panels) panels += panel_html(panel);
    return fmt::format(R"(<section class="card" id="{}"><h3>{}</h3><p>{}</p>{}{}</section>
)",
                       figure.id, escaped(figure.title), escaped(figure.caption), panels,
                       errors_html(figure));
}

std::string method_html(const StudyResult& result) {
    const ReportEnvironment environment = current_environment();
    return fmt::format(
        R"(<section class="method"><h2>How this was made</h2>
<p>{} Pictures show radiance through 1 - exp(-x), encoded for a display; their numbers are beside
this page as EXR.</p>
<dl class="environment"><dt>suite</dt><dd>{}</dd><dt>walks</dt><dd>{}</dd><dt>seed</dt><dd>{}</dd>
<dt>processor</dt><dd>{}</dd><dt>system</dt><dd>{}</dd><dt>date</dt><dd>{}</dd></dl></section>
)",
        escaped(result.suite->method), escaped(result.suite->name), result.samples, result.seed,
        escaped(environment.processor), escaped(environment.system), escaped(environment.date));
}

}  // namespace

std::string page_html(const StudyResult& result) {
    std::string figures;
    for (const Figure& figure : result.figures) figures += figure_html(figure);
    return fmt::format(
        R"(<!doctype html>
<html lang="en"><head><meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Lacquer: {}</title><style>{}{}{}</style></head><body>
{}<main>{}{}{}</main></body></html>
)",
        escaped(result.suite->title), kReportStyle, kPlotStyle, kStudyStyle, header_html(result),
        overview_html(result), figures, method_html(result));
}

}  // namespace lacquer::study
