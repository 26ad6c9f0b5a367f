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

constexpr int kCells = 9;  // of either side
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
    return kMinEta * std::pow(kMaxEta / kMinEta, (cell + 0.5) / kCells);
}

// Maps of one kind of base at one angle: columns are the coat's alpha, rows from the bottom up what
// y_of gives.
struct Field {
    std::string name;
    const char* y_name;
    double y_from, y_to;
    bool y_logarithmic;
    double (*y_of)(int row);
    double cos_theta_o;
    std::function<Material(double alpha, double y)> at;
};

struct Cell {
    double albedo, width;  // errors of the model, the width's relative; NaN: unknown
    double albedo_noise, width_noise;
};

Cell measure(const Field& field, int column, int row, const StudyRun& run) {
    const Material material = field.at(alpha_of(column), field.y_of(row));
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
    const int count = kCells * kCells;
    std::vector<Cell> cells(static_cast<std::size_t>(count));
    tbb::parallel_for(0, count, [&](int n) {
        cells[static_cast<std::size_t>(n)] = measure(field, n % kCells, n / kCells, run);
    });
    Image albedo{kCells, kCells}, width{kCells, kCells};
    for (int n = 0; n < count; ++n) {
        const Cell& cell = cells[static_cast<std::size_t>(n)];
        const int column = n % kCells, row = n / kCells;
        const auto where = [&] {
            return fmt::format("{}, alpha of the coat {:.3g}, {} {:.3g}", field.name,
                               alpha_of(column), field.y_name, field.y_of(row));
        };
        albedo.at(column, kCells - 1 - row) = {glm::vec3{static_cast<float>(cell.albedo)}, 1.0f};
        albedo_tally.add(cell.albedo, cell.albedo_noise, where);
        const bool is_known = std::isfinite(cell.width);
        width.at(column, kCells - 1 - row) = {glm::vec3{static_cast<float>(cell.width)},
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
            fields.push_back({fmt::format("gold, eta {}, cos_theta_o {}", eta, cosine),
                              "alpha of the base", 0.0, 1.0, false, alpha_of, cosine,
                              [eta](double alpha, double base) {
                                  return stack_of("", {coat(eta, alpha)}, metal("gold", base));
                              }});
    return fields;
}

std::vector<Field> lambertian_fields() {
    std::vector<Field> fields;
    for (const double cosine : kCosines)
        fields.push_back(
            {fmt::format("Lambertian, albedo 0.8, cos_theta_o {}", cosine), "eta", kMinEta, kMaxEta,
             true, eta_of, cosine, [](double alpha, double eta) {
                 return stack_of("", {coat(eta, alpha)}, LambertianBase{{0.8, 0.8, 0.8}});
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
        "One coat: errors of the albedo, averaged over the channels, and of the width of the "
        "light that met the base (standard deviation on the projected disk, relative; empty where "
        "less than a hundredth of the light did). Each cell stands for the values at its middle. "
        "Over a Lambertian base both are right everywhere. Over gold the albedo is up to 0.04 too "
        "large where smooth gold is seen at a slant, and too small where rough gold lies under a "
        "smooth coat of index 2; the width is within a tenth except for smooth metals seen at a "
        "slant and coats of less than the exterior's index, beyond whose critical angle little "
        "light gets through.",
        "albedo: mean and largest |difference|; width: the same, relative"};
    add_fields(figure, "over gold", conductor_fields(), run);
    add_fields(figure, "over a Lambertian base", lambertian_fields(), run);
    return figure;
}

}  // namespace lacquer::study
