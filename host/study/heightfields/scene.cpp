#include "study/heightfields/scene.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "core/error.h"
#include "simulator/next_event.h"
#include "simulator/rgb_estimate.h"
#include "study/layered/ball.h"

namespace lacquer::study {

namespace {

constexpr double kPi = std::numbers::pi;

// Of the room, beyond what simulate_ball makes of run.samples: rough facets scatter the light of
// small windows, and differences between blends are small.
constexpr std::uint64_t kBallWalks = 4;
constexpr std::uint64_t kLeastPoints = 64, kMostPoints = 2048;  // of a model, per ring
constexpr std::uint64_t kPointShare = 1 << 11;

constexpr int kLitSize = 64;                    // pixels of either side
constexpr std::uint64_t kPixelShare = 1 << 13;  // walks per pixel of a lit ball

glm::dvec3 direction(const glm::vec3& w) {
    return glm::normalize(glm::dvec3{w});
}

// pi f cos_theta_i of one pair of directions.
void estimate(const simulator::SurfaceWalk& surface, const Query& query, std::uint64_t walks,
              std::uint64_t seed, std::uint64_t pixel, glm::dvec3& value, glm::dvec3& error) {
    const glm::dvec3 wi = direction(query.wi), wo = direction(query.wo);
    if (!(wi.z > 0.0)) return;
    simulator::RgbMoments moments;
    for (std::uint64_t walk = 0; walk < walks; ++walk) {
        simulator::RandomStream random{seed, pixel * walks + walk};
        moments.add(kPi * simulator::next_event_density(surface, wi, wo, random));
    }
    const simulator::RgbEstimate rgb = moments.estimate(static_cast<double>(walks));
    for (int c = 0; c < 3; ++c) {
        value[c] = rgb.mean[static_cast<std::size_t>(c)];
        error[c] = rgb.standard_error[static_cast<std::size_t>(c)];
    }
}

Radiance simulate_lit(const View& view, const Material& material, std::uint64_t walks,
                      std::uint64_t seed) {
    const simulator::StackWalk stack{material};
    const simulator::SurfaceWalk* surface = stack.only_surface();
    if (surface == nullptr || !simulator::has_density(*surface))
        throw Error{"simulating '" + material.name + "': it is not one rough surface"};
    const std::size_t count = view.grid.query_count();
    Radiance radiance{std::vector<glm::dvec3>(count), std::vector<glm::dvec3>(count)};
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        estimate(*surface, query_of(view.grid, i), walks, seed, i, radiance.values[i],
                 radiance.errors[i]);
    });
    return radiance;
}

}  // namespace

Scene studio_ball(const StudyRun& run) {
    const View view = ball_view();
    StudyRun more = run;
    more.samples *= kBallWalks;
    const std::uint64_t points = std::clamp(run.share(kPointShare), kLeastPoints, kMostPoints);
    return {view,
            [view, more](const Material& material, std::string_view name) {
                return simulate_ball(view, simulator::StackWalk{material}, studio, more, name);
            },
            [view, points](const ModelLight& model) {
                return shade_ball(view, model, studio, points);
            }};
}

Scene lit_ball(double angle_deg, const StudyRun& run) {
    const double angle = angle_deg * kPi / 180.0;
    const View view{
        fmt::format("light at {:g}", angle_deg), fmt::format("light at {:g}°", angle_deg),
        sphere_grid("lit sphere", {-std::sin(angle), 0.0, std::cos(angle)}, kLitSize), 0.0};
    const std::uint64_t walks = run.share(kPixelShare);
    return {view,
            [view, walks, run](const Material& material, std::string_view name) {
                return simulate_lit(view, material, walks, run.seed_of(name));
            },
            [view](const ModelLight& model) { return shade(view, model); }};
}

}  // namespace lacquer::study
