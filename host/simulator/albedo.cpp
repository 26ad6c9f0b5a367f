#include "simulator/albedo.h"

#include <cmath>

namespace lacquer::simulator {

namespace {

using RgbMoments = std::array<Moments, 3>;

void add(RgbMoments& moments, const Vec3& weight) {
    for (int channel = 0; channel < 3; ++channel)
        moments[static_cast<std::size_t>(channel)].add(weight[channel]);
}

struct AlbedoTally {
    RgbMoments direct, base, transmitted, total;
    std::array<RgbMoments, 3> orders;
    std::uint64_t count = 0;

    void merge(const AlbedoTally& other) {
        const auto merge_rgb = [](RgbMoments& mine, const RgbMoments& others) {
            for (std::size_t channel = 0; channel < 3; ++channel)
                mine[channel].merge(others[channel]);
        };
        merge_rgb(direct, other.direct);
        merge_rgb(base, other.base);
        merge_rgb(transmitted, other.transmitted);
        merge_rgb(total, other.total);
        for (std::size_t order = 0; order < orders.size(); ++order)
            merge_rgb(orders[order], other.orders[order]);
    }
};

RgbEstimate estimate(const RgbMoments& moments, std::uint64_t count) {
    RgbEstimate result;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        const auto walks = static_cast<double>(count);
        result.mean[channel] = moments[channel].mean(walks);
        result.standard_error[channel] = moments[channel].standard_error(walks);
    }
    return result;
}

void record(const Exit& exit, AlbedoTally& tally) {
    if (exit.fate == Fate::lost) return;
    if (exit.fate == Fate::transmitted) {
        add(tally.transmitted, exit.weight);
        return;
    }
    add(exit.fate == Fate::base ? tally.base : tally.direct, exit.weight);
    add(tally.total, exit.weight);
    if (exit.order >= 1 && exit.order <= 3)
        add(tally.orders[static_cast<std::size_t>(exit.order - 1)], exit.weight);
}

}  // namespace

AlbedoEstimate estimate_albedo(const StackWalk& stack, double cos_theta_o,
                               const RunOptions& options) {
    const Vec3 wo{std::sqrt(1.0 - cos_theta_o * cos_theta_o), 0.0, cos_theta_o};
    const auto tally = run_walks<AlbedoTally>(options, [&](RandomStream& random, AlbedoTally& sum) {
        record(stack.walk(wo, random), sum);
    });
    AlbedoEstimate result;
    result.samples = tally.count;
    result.direct = estimate(tally.direct, tally.count);
    result.base = estimate(tally.base, tally.count);
    result.transmitted = estimate(tally.transmitted, tally.count);
    result.total = estimate(tally.total, tally.count);
    for (std::size_t order = 0; order < 3; ++order)
        result.orders[order] = estimate(tally.orders[order], tally.count);
    return result;
}

}  // namespace lacquer::simulator
