// Where the model `stack` can be trusted: errors of albedo and width over both roughnesses and the
// coat's index.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "core/error.h"
#include "study/error_tally.h"
#include "study/layered/compared.h"
#include "study/layered/light_statistics.h"
#include "study/layered/stacks.h"
#include "study/layered/suite.h"

namespace lacquer::study {

namespace {

constexpr int kCells = 9;  // of alpha
constexpr int kEtaCells = 9;
constexpr double kMinEta = 1.0 / 2.5, kMaxEta = 2.5;
constexpr std::uint64_t kCellShare = 1 << 6;
constexpr std::array kEtas{0.75, 1.33, 1.5, 2.0};
constexpr std::array kCosines{1.0, 0.3};
constexpr double kLeastEnergy = 0.01;  // whose width the simulation knows
constexpr double kAlbedoLimit = 0.05, kWidthLimit = 0.5;

// At the middle of a cell.
double alpha_of(int cell) {
    return (cell + 0.5) / kCells;
}

double eta_of(int cell) {
    return kMinEta * std::pow(kMaxEta / kMinEta, (cell + 0.5) / kEtaCells);
}

// Maps of one kind of base at one angle: columns are the coat's alpha, rows `y`, both upwards from
// 0.
struct Field {
    std::string name;
    const char* y_name;
    double y_from, y_to;
    bool y_logarithmic;
    int rows;
    double cos_theta_o;
    std::function<Material(double alpha, int row)> at;
};

struct Cell {
    double albedo, width;  // errors of the model, the width's relative; NaN: unknown
    double albedo_noise, width_noise;
};

Cell measure(const Field& field, int column, int row, const StudyRun& run) {
    const Material material = field.at(alpha_of(column), row);
    const LightStatistics truth =
        simulate_statistics(material, field.cos_theta_o, run.share(kCellShare), run,
                            fmt::format("validity {} {} {}", field.name, column, row));
    const Compared model = compared_on(material, Need::base).front();
    if (!model.light) throw Error{field.name + ": " + model.why_not};
    const LightStatistics shaded = model_statistics(*model.light, field.cos_theta_o);
    Cell cell{shaded.all.energy - truth.all.energy, std::nan(""), truth.all.energy_error, 0.0};
    if (truth.base.energy >= kLeastEnergy && truth.base.width > 0.0) {
        cell.width = shaded.base.width / truth.base.width - 1.0;
        cell.width_noise = truth.base.width_error / truth.base.width;
    }
    return cell;
}

Map map_of(const Field& field, const std::string& quantity, double limit, Image image) {
    Plot frame{field.name, "alpha of the coat", field.y_name, 0.0, 1.0, field.y_from, field.y_to};
    frame.y_logarithmic = field.y_logarithmic;
    return {frame, {field.name + " " + quantity, std::move(image), limit}};
}

// Appends a map of each quantity.
void add_field(const Field& field, const StudyRun& run, Maps& albedos, Maps& widths,
               ErrorTally& albedo_tally, ErrorTally& width_tally) {
    run.part("validity map, " + field.name);
    const int count = kCells * field.rows;
    std::vector<Cell> cells(static_cast<std::size_t>(count));
    tbb::parallel_for(0, count, [&](int n) {
        cells[static_cast<std::size_t>(n)] = measure(field, n % kCells, n / kCells, run);
    });
    Image albedo{kCells, field.rows}, width{kCells, field.rows};
    for (int n = 0; n < count; ++n) {
        const Cell& cell = cells[static_cast<std::size_t>(n)];
        const int column = n % kCells, row = n / kCells;
        const auto where = [&] {
            return fmt::format("{}, alpha {:.3g}, row {} of {}", field.name, alpha_of(column),
                               row + 1, field.rows);
        };
        albedo.at(column, field.rows - 1 - row) = {glm::vec3{static_cast<float>(cell.albedo)},
                                                   1.0f};
        albedo_tally.add(cell.albedo, cell.albedo_noise, where);
        const bool is_known = std::isfinite(cell.width);
        width.at(column, field.rows - 1 - row) = {glm::vec3{static_cast<float>(cell.width)},
                                                  is_known ? 1.0f : 0.0f};
        if (is_known) width_tally.add(cell.width, cell.width_noise, where);
    }
    albedos.maps.push_back(map_of(field, "albedo", kAlbedoLimit, std::move(albedo)));
    widths.maps.push_back(map_of(field, "width", kWidthLimit, std::move(width)));
    widths.maps.back().below = "too narrow";
    widths.maps.back().above = "too wide";
}

std::vector<Field> conductor_fields() {
    std::vector<Field> fields;
    for (const double cosine : kCosines)
        for (const double eta : kEtas)
            fields.push_back(
                {fmt::format("gold, eta {}, cos_theta_o {}", eta, cosine), "alpha of the base", 0.0,
                 1.0, false, kCells, cosine, [eta](double alpha, int row) {
                     return stack_of("", {coat(eta, alpha)}, metal("gold", alpha_of(row)));
                 }});
    return fields;
}

std::vector<Field> lambertian_fields() {
    std::vector<Field> fields;
    for (const double cosine : kCosines)
        fields.push_back(
            {fmt::format("Lambertian, albedo 0.8, cos_theta_o {}", cosine), "eta", kMinEta, kMaxEta,
             true, kEtaCells, cosine, [](double alpha, int row) {
                 return stack_of("", {coat(eta_of(row), alpha)}, LambertianBase{{0.8, 0.8, 0.8}});
             }});
    return fields;
}

void add_fields(Figure& figure, const std::string& base, const std::vector<Field>& fields,
                const StudyRun& run) {
    Maps albedos{base + ": albedo less the simulated", {}};
    Maps widths{base + ": width over the simulated, less 1", {}};
    ErrorTally albedo{base + ", albedo", "stack"}, width{base + ", width", "stack"};
    for (const Field& field : fields) add_field(field, run, albedos, widths, albedo, width);
    figure.errors.push_back(albedo.result());
    figure.errors.push_back(width.result());
    figure.panels.emplace_back(std::move(albedos));
    figure.panels.emplace_back(std::move(widths));
}

}  // namespace

Figure validity_map_figure(const StudyRun& run) {
    Figure figure{
        "validity-map", "Where stack can be trusted",
        "One coat: errors of the albedo, averaged over the channels, and of the width of the light "
        "that met the base (standard deviation on the projected disk, relative; empty where less "
        "than a hundredth of the light did). Red is too much or too wide. Albedos hold everywhere "
        "over a Lambertian base, and over a metal but for rough coats seen at a slant. The width "
        "of "
        "metals is the model's weak side: a lobe that has crossed a rough coat twice is no GGX "
        "lobe "
        "about the mirror direction.",
        "albedo: mean and largest |difference|; width: the same, relative"};
    add_fields(figure, "over gold", conductor_fields(), run);
    add_fields(figure, "over a Lambertian base", lambertian_fields(), run);
    return figure;
}

}  // namespace lacquer::study
