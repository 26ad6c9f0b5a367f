#include "study/heightfields/blend_pictures.h"

#include <fmt/format.h>

#include <array>
#include <glm/exponential.hpp>

#include "core/model_scope.h"
#include "image/display.h"
#include "image/flip.h"
#include "reference/models.h"
#include "study/heightfields/blended_material.h"
#include "study/material_pictures.h"

namespace lacquer::study {

const char* const kBlendMeasure =
    "mean |difference| of the pixels over their mean; max is the largest of a pixel, in radiance, "
    "beyond three standard errors. FLIP, in the tables, is what an eye sees of it";

namespace {

constexpr std::array kModels{Model::microsurface_single, Model::microsurface_compensated,
                             Model::stack};

constexpr std::size_t kHalves = 2;

// Two independent estimates, whose mean is the best there is.
using Halves = std::array<Radiance, kHalves>;

Radiance mean_of(const Halves& halves) {
    Radiance mean = halves[0];
    for (std::size_t i = 0; i < mean.values.size(); ++i) {
        const glm::dvec3 a = halves[0].errors[i], b = halves[1].errors[i];
        mean.values[i] = 0.5 * (halves[0].values[i] + halves[1].values[i]);
        mean.errors[i] = 0.5 * glm::sqrt(a * a + b * b);
    }
    return mean;
}

// A map of FLIP, and its mean over the pixels that carry light.
struct FlipMap {
    Image image;
    double mean = 0.0;
};

FlipMap flip_map(const Image& truth, const Image& other) {
    const auto reference = display_pixels(truth), test = display_pixels(other);
    const std::vector<double> values = flip(reference, test, truth.width);
    FlipMap map{Image{truth.width, truth.height}, 0.0};
    double covered = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (!(truth.pixels[n].w > 0.0f)) continue;
        map.image.pixels[n] = glm::vec4{glm::vec3{static_cast<float>(values[n])}, 1.0f};
        map.mean += values[n];
        covered += 1.0;
    }
    map.mean /= covered;
    return map;
}

// Simulates surfaces of one table, the same surface once.
class Simulated {
 public:
    Simulated(const Scene& scene, const StudyRun& run, std::string name)
        : scene_{scene}, run_{run}, name_{std::move(name)} {}

    Halves halves(const Material& material, const std::string& what) const {
        run_.part(fmt::format("{}, {}", what, scene_.view.name));
        Halves halves;
        for (std::size_t n = 0; n < kHalves; ++n)
            halves[n] = scene_.simulate(
                material, fmt::format("{} {} {} half {}", name_, what, scene_.view.name, n));
        return halves;
    }

    Radiance linear_blend(const Material& blended) {
        Radiance sum;
        for (const UniformPart& part : uniform_parts(blended)) {
            const Radiance& light = uniform(part.material);
            if (sum.values.empty()) {
                sum.values.resize(light.values.size());
                sum.errors.resize(light.values.size());
            }
            for (std::size_t i = 0; i < sum.values.size(); ++i) {
                sum.values[i] += part.weight * light.values[i];
                const glm::dvec3 error = part.weight * light.errors[i];
                sum.errors[i] = glm::sqrt(sum.errors[i] * sum.errors[i] + error * error);
            }
        }
        return sum;
    }

 private:
    const Radiance& uniform(const Material& material) {
        for (const auto& [known, light] : uniform_)
            if (known == material) return light;
        const std::string what = fmt::format("uniform surface {}", uniform_.size() + 1);
        uniform_.emplace_back(material, mean_of(halves(material, what)));
        return uniform_.back().second;
    }

    const Scene& scene_;
    const StudyRun& run_;
    std::string name_;
    std::vector<std::pair<Material, Radiance>> uniform_;
};

// The rows of one material: pictures, FLIP's maps, and the means of these.
struct Rows {
    PictureRow pictures, maps;
    std::vector<std::string> means;
};

class Cells {
 public:
    Cells(Figure& figure, const Material& material, const Scene& scene, const Halves& halves)
        : figure_{figure}, material_{material}, view_{scene.view}, truth_{mean_of(halves)} {
        rows_.pictures.label = material.name;
        rows_.maps.label = "FLIP";
        rows_.means.push_back(material.name);
        simulation_ = radiance_picture(view_, truth_, name_of("simulation"));
        rows_.pictures.pictures.push_back(simulation_);
        const FlipMap noise = flip_map(radiance_picture(view_, halves[0], {}).numbers,
                                       radiance_picture(view_, halves[1], {}).numbers);
        add_map(noise, "noise", fmt::format("{:.3f} between its halves", noise.mean));
    }

    void add(const Radiance& radiance, const std::string& name) {
        const Picture picture = radiance_picture(view_, radiance, name_of(name));
        figure_.errors.push_back(
            picture_error(view_, radiance, truth_, picture_subject(material_, view_), name));
        const FlipMap map = flip_map(simulation_.numbers, picture.numbers);
        rows_.pictures.pictures.push_back(picture);
        add_map(map, name + " FLIP",
                fmt::format("{:.3f}; {:.1f} % off", map.mean, 100.0 * figure_.errors.back().mean));
    }

    void leave_out(const std::string& why) {
        rows_.pictures.pictures.push_back({.name = {}, .note = why});
        rows_.maps.pictures.push_back({});
        rows_.means.push_back("-");
    }

    const Rows& rows() const { return rows_; }

 private:
    std::string name_of(const std::string& what) const {
        return picture_name(material_, view_, what);
    }

    void add_map(const FlipMap& map, const std::string& what, const std::string& note) {
        rows_.maps.pictures.push_back({name_of(what), map.image, kFlipLimit, note, true});
        rows_.means.push_back(fmt::format("{:.4f}", map.mean));
    }

    Figure& figure_;
    const Material& material_;
    const View& view_;
    Radiance truth_;
    Picture simulation_;
    Rows rows_;
};

Rows rows_of(Figure& figure, const Material& material, const Scene& scene, Simulated& simulated) {
    Cells cells{figure, material, scene, simulated.halves(material, material.name)};
    cells.add(simulated.linear_blend(material), kLinearBlend);
    for (const Model model : kModels) {
        const std::string name{model_name(model)};
        if (const auto why_not = why_not_shadeable(material, model))
            cells.leave_out(*why_not);
        else
            cells.add(scene.shade(ModelLight{name, reference::prepare(material, model)}), name);
    }
    return cells.rows();
}

}  // namespace

std::span<const Model> blend_models() {
    return kModels;
}

void add_blends(Figure& figure, const std::string& title, std::span<const Material> materials,
                const Scene& scene, const StudyRun& run) {
    PictureTable table{title, {"simulation", kLinearBlend}, {}};
    NumberTable means{title + ": FLIP, mean", {"", "halves of the simulation", kLinearBlend}, {}};
    for (const Model model : kModels) {
        table.columns.emplace_back(model_name(model));
        means.columns.emplace_back(model_name(model));
    }
    Simulated simulated{scene, run, figure.id + " " + title};
    for (const Material& material : materials) {
        const Rows rows = rows_of(figure, material, scene, simulated);
        table.rows.push_back(rows.pictures);
        table.rows.push_back(rows.maps);
        means.rows.push_back(rows.means);
    }
    figure.panels.emplace_back(std::move(table));
    figure.panels.emplace_back(std::move(means));
}

}  // namespace lacquer::study
