#include "study/layered/counted_slice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "simulator/slice.h"

namespace lacquer::study {

namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::uint64_t kSliceShare = 2;
constexpr int kSteps = 4;  // of a pixel's side
constexpr double kGrazing = 1e-3;

glm::dvec3 channels(const Rgb& rgb) {
    return {rgb[0], rgb[1], rgb[2]};
}

// The direction of a point of the picture in Lambert's azimuthal equal-area projection.
glm::dvec3 direction_of(double x, double y) {
    const double r2 = x * x + y * y, scale = std::sqrt(2.0 - r2);
    return {x * scale, y * scale, 1.0 - r2};
}

}  // namespace

Radiance simulate_counted_slice(const View& view, const Material& material, const StudyRun& run) {
    run.part(material.name + ", " + view.name);
    const glm::dvec3 wo = glm::normalize(glm::dvec3{query_of(view.grid, 0).wo});
    const int size = view.grid.width;
    const auto counted =
        simulator::estimate_slice(simulator::StackWalk{material}, wo, size,
                                  run.options(run.share(kSliceShare), material.name + view.name));
    Radiance radiance;
    for (std::size_t i = 0; i < view.grid.query_count(); ++i) {
        const auto pixel = view.grid.pixels[i], width = static_cast<std::uint32_t>(size);
        const auto mirrored = (width - 1 - pixel / width) * width + pixel % width;
        const double scale = 0.5 * kPi * double{query_of(view.grid, i).wi.z};
        const auto &one = counted.pixels[pixel], &other = counted.pixels[mirrored];
        radiance.values.push_back(scale * (channels(one.mean) + channels(other.mean)));
        const glm::dvec3 a = channels(one.standard_error), b = channels(other.standard_error);
        radiance.errors.push_back(scale * glm::sqrt(a * a + b * b));
    }
    return radiance;
}

Radiance shade_pixels(const View& view, const ModelLight& model) {
    const glm::dvec3 wo = glm::normalize(glm::dvec3{query_of(view.grid, 0).wo});
    const int size = view.grid.width;
    Radiance radiance{std::vector<glm::dvec3>(view.grid.query_count())};
    tbb::parallel_for(std::size_t{0}, radiance.values.size(), [&](std::size_t i) {
        const int pixel = static_cast<int>(view.grid.pixels[i]);
        glm::dvec3 light{0.0};
        double cosines = 0.0;
        for (int step = 0; step < kSteps * kSteps; ++step) {
            const double x = pixel % size + (step % kSteps + 0.5) / kSteps;
            const double y = pixel / size + (step / kSteps + 0.5) / kSteps;
            const glm::dvec3 wi = direction_of(2.0 * x / size - 1.0, 1.0 - 2.0 * y / size);
            if (!(wi.z > kGrazing)) continue;
            light += wi.z * model.eval(wi, wo);
            cosines += wi.z;
        }
        // As simulated: f averaged by the cosine, times the cosine at the middle.
        if (cosines > 0.0)
            radiance.values[i] = kPi * double{query_of(view.grid, i).wi.z} / cosines * light;
    });
    return radiance;
}

}  // namespace lacquer::study
