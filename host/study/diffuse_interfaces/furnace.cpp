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

// A row of maps.
struct Subject {
    const char* name;
    Model model;
    bool is_integrated;  // the integral of the lobes, which takes long, not a formula
    double limit;        // of the colours
    int cells;           // of either side
};

constexpr std::array kSubjects{
    Subject{"coated-exact", Model::coated_exact, false, 0.005, 65},
    Subject{"coated-exact, integral of its lobes", Model::coated_exact, true, 0.05, 13},
    Subject{"openpbr-coat", Model::openpbr_coat, true, 0.5, 13},
    Subject{"clearcoat", Model::clearcoat, true, 0.5, 13},
    Subject{"weidlich-wilkie", Model::weidlich_wilkie, true, 0.5, 13},
    Subject{"plain", Model::plain, true, 0.5, 13}};

// Of cell (column, row) from the upper left.
double alpha_of(int column, int cells) {
    return double(column) / (cells - 1);
}

double eta_of(int row, int cells) {
    return kMinEta * std::pow(kMaxEta / kMinEta, 1.0 - double(row) / (cells - 1));
}

double excess(const Subject& subject, double alpha, double eta, double cosine) {
    const Material material = coated(eta, alpha, kWhite);
    const ModelLight light = subject.is_integrated ? ModelLight::integrated(material, subject.model)
                                                   : ModelLight{material, subject.model};
    const auto albedo = light.albedo({std::sqrt(1.0 - cosine * cosine), 0.0, cosine});
    return albedo.direct.x + albedo.base.x - 1.0;
}

Image excesses(const Subject& subject, double cosine) {
    Image image{subject.cells, subject.cells};
    tbb::parallel_for(0, subject.cells * subject.cells, [&](int cell) {
        const int column = cell % subject.cells, row = cell / subject.cells;
        const double value =
            excess(subject, alpha_of(column, subject.cells), eta_of(row, subject.cells), cosine);
        image.at(column, row) = {glm::vec3{static_cast<float>(value)}, 1.0f};
    });
    return image;
}

std::string file_name(const Subject& subject, double cosine) {
    return fmt::format("{}{}_cos_{}", model_name(subject.model),
                       reads_tables(subject.model) && subject.is_integrated ? "_integral" : "",
                       cosine);
}

Map furnace_map(const Subject& subject, double cosine, ErrorTally& tally) {
    const Image image = excesses(subject, cosine);
    for (int row = 0; row < image.height; ++row)
        for (int column = 0; column < image.width; ++column)
            tally.add(image.at(column, row).x, 0.0, [&] {
                return fmt::format("eta {:.3g}, alpha {:.3g}, cos_theta {}",
                                   eta_of(row, subject.cells), alpha_of(column, subject.cells),
                                   cosine);
            });
    Plot frame{fmt::format("cos_theta {}", cosine), "alpha", "eta", 0.0, 1.0, kMinEta, kMaxEta};
    frame.y_logarithmic = true;
    return {frame, {file_name(subject, cosine), image, subject.limit}};
}

Maps furnace_maps(const Subject& subject, Figure& figure) {
    ErrorTally tally{"white furnace", subject.name};
    Maps maps{subject.name, {}};
    for (const double cosine : kCosines) maps.maps.push_back(furnace_map(subject, cosine, tally));
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
        "three angles. No simulation is needed: all light comes back. The albedo of coated-exact, "
        "that of coated-ggx too, is 1 to rounding, since all its energies follow from one table; "
        "its lobes, which renderers integrate, add up to a little more or less where the table of "
        "the light that met several facets is coarse. Mind the scales. clearcoat divides the light "
        "between coat and base and loses only what meets several facets; plain makes light from "
        "nothing; weidlich-wilkie does so near the critical angle and near grazing; openpbr-coat "
        "takes the coat's albedo for that of a smooth one.",
        "mean and largest |albedo - 1|"};
    for (const Subject& subject : kSubjects)
        figure.panels.emplace_back(furnace_maps(subject, figure));
    return figure;
}

}  // namespace lacquer::study
