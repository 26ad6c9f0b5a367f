#include "study/coat_light.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/error.h"
#include "simulator/goniophotometer.h"
#include "simulator/next_event.h"

namespace lacquer::study {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr int kSphereViewers = 64;
constexpr double kGrazing = 1e-3;               // least cos_theta_o of a viewer
constexpr std::uint64_t kPixelShare = 1 << 14;  // walks of the coat's light per pixel

struct Estimate {
    glm::dvec3 value{0.0}, error{0.0};  // and its standard error
};

Estimate operator*(double factor, const Estimate& a) {
    return {factor * a.value, factor * a.error};
}

// Of dependent or few estimates: at most this uncertain. `share` beyond [0, 1] extrapolates.
Estimate mixed(const Estimate& a, const Estimate& b, double share) {
    return {(1.0 - share) * a.value + share * b.value, std::abs(1.0 - share) * a.error + std::abs(share) * b.error};
}

Estimate independent_sum(const Estimate& a, const Estimate& b) {
    return {a.value + b.value, glm::sqrt(a.error * a.error + b.error * b.error)};
}

Estimate to_estimate(const simulator::RgbEstimate& rgb) {
    return {{rgb.mean[0], rgb.mean[1], rgb.mean[2]},
            {rgb.standard_error[0], rgb.standard_error[1], rgb.standard_error[2]}};
}

// f cos_theta_i between the middles of rings; it vanishes at the horizon.
Estimate base_density(const BaseLight& light, double cos_theta_i) {
    const double count = static_cast<double>(light.rings.size());
    const double per_solid_angle = count / (2.0 * kPi);
    const double position = cos_theta_i * count - 0.5;
    if (position <= 0.0)
        return per_solid_angle * 2.0 * cos_theta_i * count * to_estimate(light.rings.front());
    const auto ring = std::min(static_cast<std::size_t>(position), light.rings.size() - 2);
    return per_solid_angle * mixed(to_estimate(light.rings[ring]),
                                   to_estimate(light.rings[ring + 1]),
                                   position - static_cast<double>(ring));
}

Estimate total_albedo(const BaseLight& light) {
    return independent_sum(to_estimate(light.direct), to_estimate(light.base));
}

// Viewers at increasing cosines, and what lies between them.
class Viewers {
 public:
    explicit Viewers(std::vector<BaseLight> lights) : lights_{std::move(lights)} {}

    Estimate density(double cos_theta_i, double cos_theta_o) const {
        return between(cos_theta_o,
                       [&](const BaseLight& light) { return base_density(light, cos_theta_i); });
    }

    Estimate albedo(double cos_theta_o) const { return between(cos_theta_o, total_albedo); }

 private:
    template <typename Function>
    Estimate between(double cos_theta_o, const Function& function) const {
        const auto above =
            std::ranges::upper_bound(lights_, cos_theta_o, {}, &BaseLight::cos_theta_o);
        if (above == lights_.begin()) return function(lights_.front());
        if (above == lights_.end()) return function(lights_.back());
        const BaseLight& below = *(above - 1);
        const double share =
            (cos_theta_o - below.cos_theta_o) / (above->cos_theta_o - below.cos_theta_o);
        return mixed(function(below), function(*above), share);
    }

    std::vector<BaseLight> lights_;
};

Viewers simulate_viewers(const View& view, const Material& material, const StudyRun& run) {
    const simulator::StackWalk stack{material};
    const std::string name = material.name + view.name;
    if (view.grid.kernel == Kernel::slice) {
        const double cos_theta_o = query_of(view.grid, 0).wo.z;
        return Viewers{
            {simulate_base_light(stack, cos_theta_o, kRings, run.options(run.share(2), name))}};
    }
    std::vector<BaseLight> lights;
    for (int viewer = 0; viewer < kSphereViewers; ++viewer)
        lights.push_back(simulate_base_light(
            stack, std::max(double(viewer) / (kSphereViewers - 1), kGrazing), kRings,
            run.options(run.share(kSphereViewers), name + std::to_string(viewer))));
    return Viewers{std::move(lights)};
}

// The coat over nothing.
Material bare_coat(const Material& material) {
    Material coat = material;
    coat.layers.front().medium = AbsorbingMedium{};
    coat.base = NoBase{};
    return coat;
}

// f cos_theta_i of the coat's own light. A facet reflects all colours alike. By reciprocity walks
// may begin at either end: from the one nearer to grazing they seldom meet facets that mirror much
// of the light to the other.
Estimate coat_density(const simulator::SurfaceWalk& coat, const glm::dvec3& wi,
                      const glm::dvec3& wo, std::uint64_t walks, std::uint64_t seed,
                      std::uint64_t pixel) {
    const glm::dvec3 start = wi.z < wo.z ? wi : wo;
    const glm::dvec3 end = wi.z < wo.z ? wo : wi;
    simulator::Moments moments;
    for (std::uint64_t walk = 0; walk < walks; ++walk) {
        simulator::RandomStream random{seed, pixel * walks + walk};
        moments.add(simulator::next_event_density(coat, end, start, random).x);
    }
    const auto count = static_cast<double>(walks);
    const double scale = wi.z / end.z;
    return {glm::dvec3{scale * moments.mean(count)},
            glm::dvec3{scale * moments.standard_error(count)}};
}

// Which query each takes its estimate from: itself, but in a slice, where the viewer is in the
// plane y = 0, the lower half mirrors the upper.
std::vector<std::size_t> estimated_queries(const QueryGrid& grid) {
    std::vector<std::size_t> sources(grid.query_count());
    std::vector<std::size_t> query_of_pixel(static_cast<std::size_t>(grid.width) *
                                            static_cast<std::size_t>(grid.height));
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const auto width = static_cast<std::uint32_t>(grid.width);
        const auto height = static_cast<std::uint32_t>(grid.height);
        const std::uint32_t row = grid.pixels[i] / width, column = grid.pixels[i] % width;
        query_of_pixel[grid.pixels[i]] = i;
        const bool is_mirrored = grid.kernel == Kernel::slice && row > height - 1 - row;
        sources[i] = is_mirrored ? query_of_pixel[(height - 1 - row) * width + column] : i;
    }
    return sources;
}

}  // namespace

BaseLight simulate_base_light(const simulator::StackWalk& stack, double cos_theta_o, int rings,
                              const simulator::RunOptions& options) {
    const glm::dvec3 wo{std::sqrt(1.0 - cos_theta_o * cos_theta_o), 0.0, cos_theta_o};
    const auto seen = simulator::estimate_distribution(stack, wo, {rings, 1}, options);
    return {cos_theta_o, seen.base.rows, seen.base.energy, seen.direct.energy};
}

Radiance simulate(const View& view, const Material& material, const StudyRun& run) {
    run.part(material.name + ", " + view.name);
    const Viewers viewers = simulate_viewers(view, material, run);
    const simulator::StackWalk coat_stack{bare_coat(material)};
    const simulator::SurfaceWalk* coat = coat_stack.only_surface();
    if (coat == nullptr || !simulator::has_density(*coat))
        throw Error{"simulating '" + material.name + "': the coat's light has no density"};
    const std::uint64_t walks = run.share(kPixelShare);
    const std::uint64_t seed = run.seed_of(material.name + view.name + "coat");
    const std::size_t count = view.grid.query_count();
    Radiance radiance{std::vector<glm::dvec3>(count), std::vector<glm::dvec3>(count)};
    const auto estimate = [&](std::size_t i) {
        const Query query = query_of(view.grid, i);
        const glm::dvec3 wi = glm::normalize(glm::dvec3{query.wi});
        const glm::dvec3 wo = glm::normalize(glm::dvec3{query.wo});
        Estimate light;
        if (wi.z > 0.0)
            light = kPi * independent_sum(viewers.density(wi.z, wo.z),
                                          coat_density(*coat, wi, wo, walks, seed, i));
        if (view.environment > 0.0)
            light = independent_sum(light, view.environment * viewers.albedo(wo.z));
        radiance.values[i] = light.value;
        radiance.errors[i] = light.error;
    };
    const std::vector<std::size_t> sources = estimated_queries(view.grid);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        if (sources[i] == i) estimate(i);
    });
    for (std::size_t i = 0; i < count; ++i) {
        radiance.values[i] = radiance.values[sources[i]];
        radiance.errors[i] = radiance.errors[sources[i]];
    }
    return radiance;
}

}  // namespace lacquer::study
