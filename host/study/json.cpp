#include "study/json.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/version.h"

namespace lacquer::study {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json numbers(const std::vector<double>& values) {
    Json list = Json::array();
    for (const double value : values) list.push_back(number(value));
    return list;
}

Json json_of(const Figure& figure, const Picture& picture) {
    if (picture.name.empty())
        return picture.note.empty() ? Json(nullptr)
                                    : Json{{"file", nullptr}, {"note", picture.note}};
    Json json{{"file", picture_file(figure, picture)}};
    if (picture.limit) json["limit"] = *picture.limit;
    return json;
}

Json json_of(const Figure& figure, const PictureTable& table) {
    Json rows = Json::array();
    for (const PictureRow& row : table.rows) {
        Json pictures = Json::array();
        for (const Picture& picture : row.pictures) pictures.push_back(json_of(figure, picture));
        rows.push_back({{"label", row.label}, {"pictures", pictures}});
    }
    return {
        {"kind", "pictures"}, {"title", table.title}, {"columns", table.columns}, {"rows", rows}};
}

Json json_of(const Figure&, const Plots& plots) {
    Json list = Json::array();
    for (const Plot& plot : plots.plots) {
        Json curves = Json::array();
        for (const Curve& curve : plot.curves)
            curves.push_back({{"label", curve.label},
                              {"x", numbers(curve.x)},
                              {"y", numbers(curve.y)},
                              {"errors", numbers(curve.errors)}});
        list.push_back(
            {{"title", plot.title}, {"x", plot.x_label}, {"y", plot.y_label}, {"curves", curves}});
    }
    return {{"kind", "plots"}, {"title", plots.title}, {"plots", list}};
}

Json values_of(const Image& image) {
    Json rows = Json::array();
    for (int y = 0; y < image.height; ++y) {
        Json row = Json::array();
        for (int x = 0; x < image.width; ++x) row.push_back(number(image.at(x, y).x));
        rows.push_back(row);
    }
    return rows;
}

Json json_of(const Figure& figure, const Maps& maps) {
    Json list = Json::array();
    for (const Map& map : maps.maps) {
        Json json{{"title", map.frame.title},
                  {"x", map.frame.x_label},
                  {"y", map.frame.y_label},
                  {"x_range", {map.frame.x_from, map.frame.x_to}},
                  {"y_range", {map.frame.y_from, map.frame.y_to}}};
        json.update(json_of(figure, map.picture));
        json["values"] = values_of(map.picture.numbers);
        list.push_back(json);
    }
    return {{"kind", "maps"}, {"title", maps.title}, {"maps", list}};
}

Json json_of(const Figure&, const NumberTable& table) {
    return {{"kind", "table"},
            {"title", table.title},
            {"columns", table.columns},
            {"rows", table.rows}};
}

Json json_of(const ModelError& error) {
    return {{"subject", error.subject},     {"model", error.model},
            {"mean", number(error.mean)},   {"max", number(error.max)},
            {"noise", number(error.noise)}, {"where", error.where}};
}

Json json_of(const Figure& figure) {
    Json errors = Json::array(), panels = Json::array();
    for (const ModelError& error : figure.errors) errors.push_back(json_of(error));
    for (const Panel& panel : figure.panels)
        panels.push_back(std::visit([&](const auto& one) { return json_of(figure, one); }, panel));
    return {{"id", figure.id},           {"title", figure.title}, {"caption", figure.caption},
            {"measure", figure.measure}, {"errors", errors},      {"panels", panels}};
}

}  // namespace

std::string picture_file(const Figure& figure, const Picture& picture) {
    return "pictures/" + figure.id + "/" + picture.name;
}

std::string study_json(const StudyResult& result) {
    Json figures = Json::array();
    for (const Figure& figure : result.figures) figures.push_back(json_of(figure));
    const Json json{{"version", kVersion},
                    {"suite", result.suite->name},
                    {"samples", result.samples},
                    {"seed", result.seed},
                    {"figures", figures}};
    return json.dump(1) + "\n";
}

}  // namespace lacquer::study
