#include "study/layered/received.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "simulator/rgb_estimate.h"
#include "study/even_point.h"

namespace lacquer::study {

namespace {

glm::dvec3 to_world(const Frame& frame, const glm::dvec3& w) {
    return w.x * frame.x + w.y * frame.y + w.z * frame.z;
}

}  // namespace

Frame frame_towards(const glm::dvec3& normal, const glm::dvec3& viewer) {
    constexpr double kAligned = 1e-9;
    const glm::dvec3 across = viewer - glm::dot(viewer, normal) * normal;
    const glm::dvec3 any =
        std::abs(normal.x) < 0.5 ? glm::dvec3{1.0, 0.0, 0.0} : glm::dvec3{0.0, 1.0, 0.0};
    const glm::dvec3 x = glm::normalize(glm::dot(across, across) > kAligned * kAligned
                                            ? across
                                            : any - glm::dot(any, normal) * normal);
    return {x, glm::cross(normal, x), normal};
}

glm::dvec3 local_viewer(const glm::dvec3& normal, const glm::dvec3& viewer) {
    const double cosine = std::min(glm::dot(normal, viewer), 1.0);
    return {std::sqrt(1.0 - cosine * cosine), 0.0, cosine};
}

Radiance received(std::span<const Frame> frames, Surroundings surroundings, std::uint64_t count,
                  const std::function<Outgoing(std::uint64_t n)>& emit) {
    std::vector<simulator::RgbMoments> sums(frames.size());
    for (std::uint64_t n = 0; n < count; ++n) {
        const Outgoing out = emit(n);
        if (out.weight == glm::dvec3{0.0}) continue;
        const glm::dvec3 mirrored{out.direction.x, -out.direction.y, out.direction.z};
        for (std::size_t f = 0; f < frames.size(); ++f)
            sums[f].add(0.5 * out.weight *
                        (surroundings(to_world(frames[f], out.direction)) +
                         surroundings(to_world(frames[f], mirrored))));
    }
    Radiance radiance;
    for (const simulator::RgbMoments& sum : sums) {
        const simulator::RgbEstimate rgb = sum.estimate(static_cast<double>(count));
        radiance.values.emplace_back(rgb.mean[0], rgb.mean[1], rgb.mean[2]);
        radiance.errors.emplace_back(rgb.standard_error[0], rgb.standard_error[1],
                                     rgb.standard_error[2]);
    }
    return radiance;
}

Radiance received_evenly(std::span<const Frame> frames, Surroundings surroundings,
                         std::uint64_t count,
                         const std::function<Outgoing(std::uint64_t n)>& emit) {
    const std::uint64_t half = count / 2;
    Radiance radiance = received(frames, surroundings, half, emit);
    const Radiance other =
        received(frames, surroundings, half, [&](std::uint64_t n) { return emit(half + n); });
    for (std::size_t f = 0; f < frames.size(); ++f) {
        const glm::dvec3 one = radiance.values[f];
        radiance.values[f] = 0.5 * (one + other.values[f]);
        radiance.errors[f] = 0.5 * glm::abs(one - other.values[f]);
    }
    return radiance;
}

Outgoing walked(const simulator::StackWalk& stack, const glm::dvec3& wo, std::uint64_t seed,
                std::uint64_t n, int max_order) {
    simulator::RandomStream random{seed, n};
    const simulator::Exit exit = stack.walk(wo, random);
    if (exit.fate == simulator::Fate::lost || exit.order > max_order) return {};
    return {exit.direction, exit.weight};
}

Outgoing sampled(const ModelLight& model, const glm::dvec3& wo, std::uint64_t n) {
    const reference::Sample sample = model.sample(wo, even_point(static_cast<int>(n)));
    return {sample.wi, sample.weight};
}

}  // namespace lacquer::study
