#include "study/material_pictures.h"

#include <fmt/format.h>

#include <array>

namespace lacquer::study {

namespace {

constexpr std::array kCompared{Model::coated_exact, Model::coated_ggx,      Model::openpbr_coat,
                               Model::clearcoat,    Model::weidlich_wilkie, Model::plain};

std::string error_note(const ModelError& error) {
    return fmt::format("{:.1f} % off", 100.0 * error.mean);
}

struct Rows {
    PictureRow pictures, differences;
};

Rows rows_of(Figure& figure, const Material& material, const View& view, const Radiance& truth,
             std::span<const ModelLight> compared) {
    const std::string subject = picture_subject(material, view);
    Rows rows{{view.label, {}}, {"difference", {}}};
    rows.pictures.pictures.push_back(
        radiance_picture(view, truth, picture_name(material, view, "simulation")));
    rows.differences.pictures.push_back({});
    for (const ModelLight& model : compared) {
        const Radiance radiance = shade(view, model);
        figure.errors.push_back(picture_error(view, radiance, truth, subject, model.name()));
        rows.pictures.pictures.push_back(
            radiance_picture(view, radiance, picture_name(material, view, model.name())));
        rows.differences.pictures.push_back(
            difference_picture(view, radiance, truth, kDifferenceLimit,
                               picture_name(material, view, model.name() + " difference")));
        rows.differences.pictures.back().note = error_note(figure.errors.back());
    }
    return rows;
}

}  // namespace

std::vector<ModelLight> models_of(const Material& material, std::span<const Model> models) {
    std::vector<ModelLight> result;
    for (const Model model : models) result.emplace_back(material, model);
    return result;
}

std::span<const Model> compared_models() {
    return kCompared;
}

std::string picture_subject(const Material& material, const View& view) {
    return fmt::format("{}: {}", material.name, view.name);
}

std::string picture_name(const Material& material, const View& view, const std::string& what) {
    std::string name;
    for (const char c : material.name + " " + view.name + " " + what) {
        if (c == ' ' || c == '/')
            name += '_';
        else if (c != ',')
            name += c;
    }
    return name;
}

void add_material(Figure& figure, const Material& material, std::span<const View> views,
                  std::span<const Radiance> truth, std::span<const ModelLight> compared) {
    PictureTable table{material.name, {"simulation"}, {}};
    for (const ModelLight& model : compared) table.columns.push_back(model.name());
    for (std::size_t v = 0; v < views.size(); ++v) {
        Rows rows = rows_of(figure, material, views[v], truth[v], compared);
        table.rows.push_back(std::move(rows.pictures));
        table.rows.push_back(std::move(rows.differences));
    }
    figure.panels.emplace_back(std::move(table));
}

}  // namespace lacquer::study
