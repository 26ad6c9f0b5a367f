#include "study/layered/stack_pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "study/layered/ball.h"
#include "study/layered/counted_slice.h"
#include "study/material_pictures.h"

namespace lacquer::study {

const char* const kPictureMeasure =
    "mean |difference| of the pixels over their mean; max is the largest of a pixel, in radiance, "
    "beyond three standard errors. The noise is that of the simulation and of the models' own "
    "samples, by which balls and plates are shaded";

namespace {

// Samples of a model per pixel of a ball, for so many walks. Over a Lambertian base stack takes
// long for each, and its light is even.
std::uint64_t points_for(const Material& material, const StudyRun& run) {
    const std::uint64_t points = std::clamp<std::uint64_t>(run.share(1 << 12), 64, 1024);
    return std::holds_alternative<LambertianBase>(material.base) ? points / 4 : points;
}

Radiance shade_shown(const Shown& shown, const ModelLight& model) {
    return shown.view.has_beam ? shade_pixels(shown.view, model)
                               : shade_ball(shown.view, model, studio, shown.points);
}

// Pictures of one material by one model or method, and its error.
void add_cells(Figure& figure, const Shown& shown, const Radiance& radiance,
               const std::string& name, PictureRow& pictures, PictureRow& differences) {
    const auto& [material, view, truth, points] = shown;
    const ModelError error =
        picture_error(view, radiance, truth, picture_subject(material, view), name);
    pictures.pictures.push_back(
        radiance_picture(view, radiance, picture_name(material, view, name)));
    differences.pictures.push_back(
        difference_picture(view, radiance, truth, kDifferenceLimit,
                           picture_name(material, view, name + " difference")));
    differences.pictures.back().note = fmt::format("{:.1f} % off", 100.0 * error.mean);
    figure.errors.push_back(error);
}

}  // namespace

Shown shown_ball(const Material& material, const StudyRun& run) {
    run.part(material.name + ", sphere");
    const View view = ball_view();
    return {
        material, view,
        simulate_ball(view, simulator::StackWalk{material}, studio, run, material.name + view.name),
        points_for(material, run)};
}

Shown shown_slice(const Material& material, double theta_o_deg, const StudyRun& run) {
    const View view = slice_view(theta_o_deg);
    return {material, view, simulate_counted_slice(view, material, run)};
}

void add_pictures(Figure& figure, const std::string& title, std::span<const Shown> shown) {
    PictureTable table{title, {"simulation"}, {}};
    for (const Shown& one : shown) {
        const std::vector<Compared> compared = compared_on(one.material);
        PictureRow pictures{one.material.name, {}}, differences{"difference", {}};
        if (one.view.has_beam) pictures.label += ", " + one.view.label;
        pictures.pictures.push_back(radiance_picture(
            one.view, one.truth, picture_name(one.material, one.view, "simulation")));
        differences.pictures.push_back({});
        for (const Compared& model : compared) {
            if (model.light) {
                add_cells(figure, one, shade_shown(one, *model.light), model.name, pictures,
                          differences);
            } else {
                pictures.pictures.push_back({.name = {}, .note = model.why_not});
                differences.pictures.push_back({});
            }
        }
        if (table.rows.empty())
            for (const Compared& model : compared) table.columns.push_back(model.name);
        table.rows.push_back(std::move(pictures));
        table.rows.push_back(std::move(differences));
    }
    figure.panels.emplace_back(std::move(table));
}

void add_column(Figure& figure, const std::string& name, std::span<const Shown> shown,
                std::span<const Radiance> pictures) {
    auto& table = std::get<PictureTable>(figure.panels.back());
    table.columns.push_back(name);
    for (std::size_t n = 0; n < shown.size(); ++n)
        add_cells(figure, shown[n], pictures[n], name, table.rows[2 * n], table.rows[2 * n + 1]);
}

}  // namespace lacquer::study
