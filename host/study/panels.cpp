#include "study/panels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "markup/markup.h"
#include "study/display.h"
#include "study/errors.h"

namespace lacquer::study {

namespace {

std::string title_html(const std::string& title) {
    return title.empty() ? "" : fmt::format("<h4>{}</h4>", escaped(title));
}

std::string picture_html(const Picture& picture, const std::string& what) {
    if (picture.name.empty())
        return fmt::format("<div class=\"absent\">{}</div>", escaped(picture.note));
    return fmt::format(
        R"(<figure><img width="{}" height="{}" alt="{}" decoding="async" src="{}">{}</figure>)",
        picture.numbers.width, picture.numbers.height, escaped(what), png_data_uri(png_of(picture)),
        picture.note.empty() ? ""
                             : fmt::format("<figcaption>{}</figcaption>", escaped(picture.note)));
}

// The largest limit of the pictures of one kind of differences, which share one; 0 where none shows
// them.
double limit_of(const PictureTable& table, bool to_the_eye) {
    double limit = 0.0;
    for (const PictureRow& row : table.rows)
        for (const Picture& picture : row.pictures)
            if (picture.to_the_eye == to_the_eye)
                limit = std::max(limit, picture.limit.value_or(0.0));
    return limit;
}

std::string legends_of(const PictureTable& table) {
    const double signed_limit = limit_of(table, false), flip_limit = limit_of(table, true);
    return (signed_limit > 0.0 ? difference_legend(signed_limit) : "") +
           (flip_limit > 0.0 ? flip_legend(flip_limit) : "");
}

std::string html_of(const PictureTable& table) {
    std::string cells = "<span></span>";
    for (const std::string& column : table.columns)
        cells += fmt::format("<b>{}</b>", escaped(column));
    for (const PictureRow& row : table.rows) {
        cells += fmt::format("<span>{}</span>", escaped(row.label));
        for (std::size_t n = 0; n < row.pictures.size(); ++n)
            cells += picture_html(row.pictures[n], row.label + ", " + table.columns[n]);
    }
    return fmt::format(
        R"(<div class="panel">{}<div class="pictures" style="--columns:{};--width:{}px">{}</div>{}</div>)",
        title_html(table.title), table.columns.size(), table.column_width, cells,
        legends_of(table));
}

std::string html_of(const Plots& plots) {
    std::string svg;
    for (const Plot& plot : plots.plots) svg += svg_of(plot);
    return fmt::format(R"(<div class="panel">{}<div class="plots">{}</div></div>)",
                       title_html(plots.title), svg);
}

std::string html_of(const Maps& maps) {
    std::string svg;
    for (const Map& map : maps.maps) {
        Plot frame = map.frame;
        frame.backdrop = png_data_uri(png_of(map.picture));
        svg +=
            fmt::format("<div>{}{}</div>", svg_of(frame),
                        difference_legend(map.picture.limit.value_or(1.0), map.below, map.above));
    }
    return fmt::format(R"(<div class="panel">{}<div class="plots">{}</div></div>)",
                       title_html(maps.title), svg);
}

std::string html_of(const NumberTable& table) {
    std::string head, rows;
    for (const std::string& column : table.columns)
        head += fmt::format(R"(<th class="num">{}</th>)", escaped(column));
    for (const auto& row : table.rows) {
        rows += "<tr>";
        for (const std::string& cell : row)
            rows += fmt::format(R"(<td class="num">{}</td>)", escaped(cell));
        rows += "</tr>\n";
    }
    return fmt::format(
        R"(<div class="panel">{}<div class="scroll"><table><thead><tr>{}</tr></thead><tbody>
{}</tbody></table></div></div>)",
        title_html(table.title), head, rows);
}

}  // namespace

std::string panel_html(const Panel& panel) {
    return std::visit([](const auto& one) { return html_of(one); }, panel);
}

std::string error_cell(double mean, const std::string& below, const std::string& detail) {
    // From green at kSmall to red at kLarge.
    constexpr double kSmall = 0.003, kLarge = 0.3, kGoodHue = 155.0, kBadHue = 4.0;
    const double place =
        std::clamp(std::log(std::max(mean, kSmall) / kSmall) / std::log(kLarge / kSmall), 0.0, 1.0);
    return fmt::format(R"(<td class="num margin" style="--hue:{:.0f}" title="{}">{:.4f}{}</td>)",
                       kGoodHue + place * (kBadHue - kGoodHue), escaped(detail), mean,
                       below.empty() ? "" : fmt::format("<small>{}</small>", escaped(below)));
}

std::string errors_html(const Figure& figure) {
    if (figure.errors.empty()) return {};
    const std::vector<std::string> subjects = error_subjects(figure);
    std::string head = "<th></th>", rows, noise = "<tr><th>what noise makes of the mean</th>";
    for (const std::string& subject : subjects) {
        head += fmt::format(R"(<th class="num">{}</th>)", escaped(subject));
        const double of_mean = noise_of(figure, subject);
        noise += of_mean > 0.0 ? fmt::format(R"(<td class="num">{:.4f}</td>)", of_mean)
                               : R"(<td class="num none">–</td>)";
    }
    for (const std::string& model : error_models(figure)) {
        rows += fmt::format("<tr><th>{}</th>", escaped(model));
        for (const std::string& subject : subjects) {
            const ModelError* error = find_error(figure, subject, model);
            rows += error == nullptr
                        ? R"(<td class="num none">–</td>)"
                        : error_cell(error->mean, fmt::format("max {:.3g}", error->max),
                                     error->where.empty() ? "" : "largest at " + error->where);
        }
        rows += "</tr>\n";
    }
    return fmt::format(
        R"(<div class="panel"><h4>Errors: {}</h4><div class="scroll"><table class="errors"><thead>
<tr>{}</tr></thead><tbody>{}{}</tr></tbody></table></div></div>)",
        escaped(figure.measure), head, rows, noise);
}

}  // namespace lacquer::study
