// Figure 15 of 2018: flat plates of varying roughness, one that reflects and one of tinted glass.
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "study/error_tally.h"
#include "study/layered/compared.h"
#include "study/layered/received.h"
#include "study/layered/stack_pictures.h"
#include "study/layered/stacks.h"
#include "study/layered/suite.h"
#include "study/material_pictures.h"

namespace lacquer::study {

namespace {

constexpr int kCells = 49;  // of either side of a plate
constexpr std::uint64_t kCellShare = 1 << 11;
constexpr std::uint64_t kModelPoints = 512;  // of each cell
using std::numbers::pi;
constexpr double kSureErrors = 3.0;

enum class Side { reflected, transmitted };

// One cell of a plate: its material, and how it lies before the viewer.
struct Cell {
    Material material;
    glm::dvec3 normal, viewer;  // in the world
};

struct Plate {
    std::string name;
    Side side;
    Cell (*at)(double x, double y);  // both in [0, 1], y upwards
};

double angle_of(double share) {
    constexpr double kMost_deg = 85.0;
    return share * kMost_deg * pi / 180.0;
}

// On a table: roughness of the metal to the right, viewers ever lower upwards.
Cell metal_cell(double x, double y) {
    constexpr double kAside = 0.2;  // the middle of the window is a bar
    const double theta = angle_of(y);
    return {stack_of("metal plate", {coat(2.0, 0.0)}, grey_conductor(1.0, 0.5, x)),
            {0.0, 1.0, 0.0},
            {kAside, std::cos(theta), std::sin(theta)}};
}

// Upright before the room, roughness of its front to the right, of its back upwards; the viewer
// looks up through it to the window at the back.
Cell glass_cell(double x, double y) {
    constexpr double kUp_deg = 35.0;
    const double theta = kUp_deg * pi / 180.0;
    const Rgb tau{std::exp(-1.0), std::exp(-0.7), std::exp(-0.2)};
    return {stack_of("tinted glass plate", {coat(1.8, x, tau), coat(1.0, y)}, NoBase{}),
            {0.0, 0.0, 1.0},
            {0.15, -std::sin(theta), std::cos(theta)}};
}

const Plate kPlates[] = {{"metal plate", Side::reflected, metal_cell},
                         {"glass plate, reflected", Side::reflected, glass_cell},
                         {"glass plate, transmitted", Side::transmitted, glass_cell}};

using Emit = std::function<Outgoing(std::uint64_t)>;

// Only light to one side.
Emit only(Side side, Emit emit) {
    return [side, emit = std::move(emit)](std::uint64_t n) {
        const Outgoing out = emit(n);
        return (out.direction.z < 0.0) == (side == Side::transmitted) ? out : Outgoing{};
    };
}

struct Seen {
    glm::dvec3 value{0.0}, error{0.0};
};

using Receive = decltype(received);

Seen seen_in(const Cell& cell, const Receive& receive, std::uint64_t count, const Emit& emit) {
    const std::array frames{frame_towards(cell.normal, glm::normalize(cell.viewer))};
    const Radiance radiance = receive(frames, studio, count, emit);
    return {radiance.values.front(), radiance.errors.front()};
}

Cell cell_at(const Plate& plate, std::size_t index) {
    const double column = static_cast<double>(index % kCells);
    const double row = static_cast<double>(index / kCells);
    return plate.at(column / (kCells - 1), 1.0 - row / (kCells - 1));
}

glm::dvec3 viewer_of(const Cell& cell) {
    return local_viewer(cell.normal, glm::normalize(cell.viewer));
}

using Cells = std::vector<Seen>;

template <typename See>
Cells see_cells(const See& see) {
    Cells cells(static_cast<std::size_t>(kCells * kCells));
    tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t i) { cells[i] = see(i); });
    return cells;
}

Cells simulate_plate(const Plate& plate, const StudyRun& run) {
    run.part(plate.name);
    const std::uint64_t seed = run.seed_of(plate.name), count = run.share(kCellShare);
    return see_cells([&](std::size_t i) {
        const Cell cell = cell_at(plate, i);
        const simulator::StackWalk stack{cell.material};
        const glm::dvec3 wo = viewer_of(cell);
        return seen_in(cell, received, count, only(plate.side, [&](std::uint64_t n) {
                           return walked(stack, wo, seed, i * count + n);
                       }));
    });
}

Cells shade_plate(const Plate& plate, std::size_t model) {
    return see_cells([&](std::size_t i) {
        const Cell cell = cell_at(plate, i);
        const std::vector<Compared> compared = compared_on(cell.material);
        const glm::dvec3 wo = viewer_of(cell);
        return seen_in(cell, received_evenly, kModelPoints, only(plate.side, [&](std::uint64_t n) {
                           return sampled(*compared[model].light, wo, n);
                       }));
    });
}

Picture picture_of(const Cells& cells, const std::string& name) {
    Picture picture{name, Image{kCells, kCells}};
    for (std::size_t i = 0; i < cells.size(); ++i)
        picture.numbers.pixels[i] = glm::vec4{glm::dvec4{cells[i].value, 1.0}};
    return picture;
}

double mean_of(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0;
}

Picture difference_of(const Cells& cells, const Cells& truth, const std::string& name) {
    Picture picture{name, Image{kCells, kCells}, kDifferenceLimit};
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const double difference = mean_of(cells[i].value - truth[i].value);
        picture.numbers.pixels[i] = {glm::vec3{static_cast<float>(difference)}, 1.0f};
    }
    return picture;
}

ModelError plate_error(const Cells& cells, const Cells& truth, const std::string& subject,
                       const std::string& model) {
    ErrorTally tally{subject, model, kSureErrors};
    double all = 0.0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        tally.add(mean_of(glm::abs(cells[i].value - truth[i].value)),
                  std::hypot(mean_of(truth[i].error), mean_of(cells[i].error)), [&] {
                      return fmt::format("x {:.2f}, y {:.2f}", double(i % kCells) / (kCells - 1),
                                         1.0 - double(i / kCells) / (kCells - 1));
                  });
        all += mean_of(truth[i].value);
    }
    return tally.result(all);
}

// What a model cannot do with a plate, or nothing.
std::string why_not(const Plate& plate, const Compared& model, const Cells& cells) {
    if (!model.light) return model.why_not;
    const bool is_dark =
        std::ranges::all_of(cells, [](const Seen& seen) { return seen.value == glm::dvec3{0.0}; });
    if (plate.side == Side::transmitted && is_dark)
        return fmt::format("the model '{}' has no transmitted lobe", model.name);
    return {};
}

void add_plate(Figure& figure, const Plate& plate, const StudyRun& run) {
    const Cells truth = simulate_plate(plate, run);
    PictureTable table{plate.name, {"simulation"}, {}};
    PictureRow pictures{plate.name, {picture_of(truth, plate.name + " simulation")}};
    PictureRow differences{"difference", {{}}};
    const std::vector<Compared> compared = compared_on(cell_at(plate, 0).material);
    for (std::size_t m = 0; m < compared.size(); ++m) {
        const std::string& model = compared[m].name;
        table.columns.push_back(model);
        const Cells cells = compared[m].light ? shade_plate(plate, m) : Cells{};
        const std::string why = why_not(plate, compared[m], cells);
        if (!why.empty()) {
            pictures.pictures.push_back({.name = {}, .note = why});
            differences.pictures.push_back({});
            continue;
        }
        figure.errors.push_back(plate_error(cells, truth, plate.name, model));
        pictures.pictures.push_back(picture_of(cells, plate.name + " " + model));
        differences.pictures.push_back(
            difference_of(cells, truth, plate.name + " " + model + " difference"));
        differences.pictures.back().note =
            fmt::format("{:.1f} % off", 100.0 * figure.errors.back().mean);
    }
    table.rows = {std::move(pictures), std::move(differences)};
    figure.panels.emplace_back(std::move(table));
}

}  // namespace

Figure plates_figure(const StudyRun& run) {
    Figure figure{
        "figure-15", "Figure 15: plates of varying roughness",
        "The metal plate, index 1 + 0.5 i under a smooth coat of index 2, lies on a table below "
        "the "
        "window at the back: the metal's alpha goes from 0 to 1 to the right, the viewer's angle "
        "from 0 to 85 degrees upwards. The coat mirrors the window sharply everywhere, the metal "
        "less and less. The glass plate, index 1.8, absorbs 1, 0.7 and 0.2; the alpha of its front "
        "goes from 0 to 1 to the right, that of its back upwards. What it lets through is blurred "
        "by both.",
        kPictureMeasure};
    for (const Plate& plate : kPlates) add_plate(figure, plate, run);
    return figure;
}

}  // namespace lacquer::study
