#include "study/view.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "study/error_tally.h"

namespace lacquer::study {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSphereSize = 160, kSliceSize = 120;
constexpr double kSureErrors = 3.0;
constexpr double kEnvironment = 0.3;  // fills the shadow without hiding the terminator

// Directional albedos of isotropic surfaces over cos_theta_o: some models take long for each.
class AlbedoCurve {
 public:
    explicit AlbedoCurve(const ModelLight& model)
        : values_(model.has_albedo() ? kManyNodes : kFewNodes) {
        tbb::parallel_for(std::size_t{0}, values_.size(), [&](std::size_t node) {
            const double z = std::max(double(node) / double(values_.size() - 1), kGrazing);
            const auto albedo = model.albedo({std::sqrt(1.0 - z * z), 0.0, z});
            values_[node] = albedo.direct + albedo.base;
        });
    }

    glm::dvec3 at(double cos_theta) const {
        const double position = std::clamp(cos_theta, 0.0, 1.0) * double(values_.size() - 1);
        const auto node = std::min(static_cast<std::size_t>(position), values_.size() - 2);
        const double share = position - static_cast<double>(node);
        return (1.0 - share) * values_[node] + share * values_[node + 1];
    }

 private:
    static constexpr std::size_t kManyNodes = 257, kFewNodes = 49;
    static constexpr double kGrazing = 1e-3;

    std::vector<glm::dvec3> values_;
};

double mean(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0;
}

double angle_deg(float cos_theta) {
    return std::acos(std::clamp(double{cos_theta}, -1.0, 1.0)) * 180.0 / kPi;
}

}  // namespace

View sphere_view() {
    return {"sphere", "sphere", sphere_grid("sphere", default_light(), kSphereSize), kEnvironment};
}

View slice_view(double theta_o_deg) {
    const std::string name = fmt::format("slice {}", theta_o_deg);
    return {name, fmt::format("slice, {}°", theta_o_deg),
            slice_grid(name, direction_at(theta_o_deg), kSliceSize), 0.0};
}

Radiance shade(const View& view, const ModelLight& model) {
    std::optional<AlbedoCurve> albedo;
    if (view.environment > 0.0) albedo.emplace(model);
    Radiance radiance{std::vector<glm::dvec3>(view.grid.query_count())};
    tbb::parallel_for(std::size_t{0}, radiance.values.size(), [&](std::size_t i) {
        const Query query = query_of(view.grid, i);
        const glm::dvec3 wi = glm::normalize(glm::dvec3{query.wi});
        const glm::dvec3 wo = glm::normalize(glm::dvec3{query.wo});
        glm::dvec3& value = radiance.values[i];
        value = kPi * std::max(wi.z, 0.0) * model.eval(wi, wo);
        if (albedo) value += view.environment * albedo->at(wo.z);
    });
    return radiance;
}

Picture radiance_picture(const View& view, const Radiance& radiance, const std::string& name) {
    std::vector<glm::dvec4> rows;
    rows.reserve(radiance.values.size());
    for (const glm::dvec3& value : radiance.values) rows.emplace_back(value, 1.0);
    return {name, paint(view.grid, rows)};
}

Picture difference_picture(const View& view, const Radiance& radiance, const Radiance& truth,
                           double limit, const std::string& name) {
    std::vector<glm::dvec4> rows;
    rows.reserve(radiance.values.size());
    for (std::size_t i = 0; i < radiance.values.size(); ++i)
        rows.emplace_back(glm::dvec3{mean(radiance.values[i] - truth.values[i])}, 1.0);
    return {name, paint(view.grid, rows), limit};
}

ModelError picture_error(const View& view, const Radiance& radiance, const Radiance& truth,
                         const std::string& subject, std::string_view model) {
    ErrorTally tally{subject, std::string{model}, kSureErrors};
    double all = 0.0;
    for (std::size_t i = 0; i < radiance.values.size(); ++i) {
        const auto where = [&] {
            const Query query = query_of(view.grid, i);
            const std::string viewer = fmt::format("viewer at {:.0f}", angle_deg(query.wo.z));
            if (!view.has_beam) return viewer + " degrees";
            return fmt::format("light at {:.0f} degrees, {}", angle_deg(query.wi.z), viewer);
        };
        const double own = radiance.errors.empty() ? 0.0 : mean(radiance.errors[i]);
        tally.add(mean(glm::abs(radiance.values[i] - truth.values[i])),
                  std::hypot(mean(truth.errors[i]), own), where);
        all += mean(truth.values[i]);
    }
    return tally.result(all);
}

}  // namespace lacquer::study
