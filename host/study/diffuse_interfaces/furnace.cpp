// A white base under a clear coat returns all light.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "study/diffuse_interfaces/materials.h"
#include "study/diffuse_interfaces/suite.h"
#include "study/error_tally.h"
#include "study/material_pictures.h"

namespace lacquer::study {

namespace {

constexpr double kMinEta = 1.0 / 3.0, kMaxEta = 3.0;
constexpr std::array kCosines{1.0, 0.5, 0.1};
constexpr double kCoatedLimit = 0.005, kBaselineLimit = 0.5;
// The baselines' albedos are integrals, which take long.
constexpr int kCoatedCells = 65, kBaselineCells = 17;

// Of cell (column, row) from the upper left.
double alpha_of(int column, int cells) {
    return double(column) / (cells - 1);
}

double eta_of(int row, int cells) {
    return kMinEta * std::pow(kMaxEta / kMinEta, 1.0 - double(row) / (cells - 1));
}

double excess(Model model, double alpha, double eta, double cosine) {
    const ModelLight light{coated(eta, alpha, kWhite), model};
    const auto albedo = light.albedo({std::sqrt(1.0 - cosine * cosine), 0.0, cosine});
    return albedo.direct.x + albedo.base.x - 1.0;
}

Map furnace_map(Model model, double cosine, ErrorTally& tally) {
    const bool is_coated = reads_tables(model);
    const int cells = is_coated ? kCoatedCells : kBaselineCells;
    Image image{cells, cells};
    tbb::parallel_for(0, cells * cells, [&](int cell) {
        const int column = cell % cells, row = cell / cells;
        const double value = excess(model, alpha_of(column, cells), eta_of(row, cells), cosine);
        image.at(column, row) = {glm::vec3{static_cast<float>(value)}, 1.0f};
    });
    for (int cell = 0; cell < cells * cells; ++cell) {
        const int column = cell % cells, row = cell / cells;
        tally.add(image.at(column, row).x, 0.0, [&] {
            return fmt::format("eta {:.3g}, alpha {:.3g}, cos_theta {}", eta_of(row, cells),
                               alpha_of(column, cells), cosine);
        });
    }
    Plot frame{fmt::format("{}, cos_theta {}", model_name(model), cosine),
               "alpha",
               "eta",
               0.0,
               1.0,
               kMinEta,
               kMaxEta};
    frame.y_logarithmic = true;
    return {frame,
            {fmt::format("{}_cos_{}", model_name(model), cosine), image,
             is_coated ? kCoatedLimit : kBaselineLimit}};
}

Maps furnace_maps(Model model, Figure& figure) {
    ErrorTally tally{"white furnace", std::string{model_name(model)}};
    Maps maps;
    for (const double cosine : kCosines) maps.maps.push_back(furnace_map(model, cosine, tally));
    figure.errors.push_back(tally.result());
    return maps;
}

}  // namespace

Figure furnace_figure(const StudyRun& run) {
    run.part("white furnace");
    Figure figure{
        "white-furnace", "White furnace: albedo 1, tau 1, nothing is lost",
        "What each model's albedo exceeds 1 by, over the coat's roughness and index, for viewers "
        "at "
        "three angles. No simulation is needed: all light comes back. coated-ggx has the energies "
        "of "
        "coated-exact. Mind the scales: the baselines' is a hundred times as wide. clearcoat and "
        "plain, whose base shines through the coat as if bare, make light from nothing; "
        "weidlich-wilkie does where the solid angle that refraction compresses matters; "
        "openpbr-coat loses what lies beyond the critical angle, and at grazing angles of rough "
        "coats.",
        "mean and largest |albedo - 1|"};
    for (const Model model : compared_models()) {
        if (model == Model::coated_ggx) continue;
        figure.panels.emplace_back(furnace_maps(model, figure));
    }
    return figure;
}

}  // namespace lacquer::study
