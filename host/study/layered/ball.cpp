#include "study/layered/ball.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace lacquer::study {

namespace {

constexpr int kBallSize = 96;
constexpr std::uint64_t kBallShare = 4;
constexpr std::uint64_t kLeastWalks = 16;  // per ring
constexpr glm::dvec3 kCamera{0.0, 0.0, 1.0};

// Queries of equal distance from the middle, that see the material under one angle.
struct Ring {
    glm::dvec3 wo;
    std::vector<std::size_t> queries;
    std::vector<Frame> frames;
};

std::vector<Ring> rings_of(const QueryGrid& grid) {
    std::map<int, Ring> by_distance;
    for (std::size_t i = 0; i < grid.query_count(); ++i) {
        const int pixel = static_cast<int>(grid.pixels[i]);
        const int x = 2 * (pixel % grid.width) + 1 - grid.width;
        const int y = grid.height - 1 - 2 * (pixel / grid.width);
        const double size = grid.width;
        const glm::dvec3 normal{x / size, y / size,
                                std::sqrt(1.0 - (double(x) * x + double(y) * y) / (size * size))};
        Ring& ring = by_distance[x * x + y * y];
        ring.wo = local_viewer(normal, kCamera);
        ring.queries.push_back(i);
        ring.frames.push_back(frame_towards(normal, kCamera));
    }
    std::vector<Ring> rings;
    for (auto& [distance, ring] : by_distance) rings.push_back(std::move(ring));
    return rings;
}

// `receive(ring index, ring)` gives the radiance in each of the ring's frames.
template <typename Receive>
Radiance on_ball(const View& view, const std::vector<Ring>& rings, const Receive& receive) {
    Radiance radiance{std::vector<glm::dvec3>(view.grid.query_count()),
                      std::vector<glm::dvec3>(view.grid.query_count())};
    tbb::parallel_for(std::size_t{0}, rings.size(), [&](std::size_t r) {
        const Ring& ring = rings[r];
        const Radiance part = receive(r, ring);
        for (std::size_t n = 0; n < ring.queries.size(); ++n) {
            radiance.values[ring.queries[n]] = part.values[n];
            radiance.errors[ring.queries[n]] = part.errors[n];
        }
    });
    return radiance;
}

}  // namespace

View ball_view() {
    return {"sphere", "sphere", sphere_grid("sphere", kCamera, kBallSize), 0.0, false};
}

Radiance simulate_ball(const View& view, const simulator::StackWalk& stack,
                       Surroundings surroundings, const StudyRun& run, std::string_view name,
                       int max_order) {
    const std::vector<Ring> rings = rings_of(view.grid);
    const std::uint64_t count = std::max(run.share(kBallShare) / rings.size(), kLeastWalks);
    const std::uint64_t seed = run.seed_of(name);
    return on_ball(view, rings, [&](std::size_t r, const Ring& ring) {
        return received(ring.frames, surroundings, count, [&](std::uint64_t n) {
            return walked(stack, ring.wo, seed, r * count + n, max_order);
        });
    });
}

Radiance shade_ball(const View& view, const ModelLight& model, Surroundings surroundings,
                    std::uint64_t points) {
    return on_ball(view, rings_of(view.grid), [&](std::size_t r, const Ring& ring) {
        return received_evenly(ring.frames, surroundings, points, [&](std::uint64_t n) {
            return sampled(model, ring.wo, r * points + n);
        });
    });
}

}  // namespace lacquer::study
