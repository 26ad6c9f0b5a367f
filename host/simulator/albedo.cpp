#include "simulator/albedo.h"

#include <cmath>

namespace lacquer::simulator {

namespace {

struct AlbedoTally {
    RgbMoments direct, base, transmitted, total;
    std::array<RgbMoments, 3> orders;
    std::uint64_t count = 0;

    void merge(const AlbedoTally& other) {
        direct.merge(other.direct);
        base.merge(other.base);
        transmitted.merge(other.transmitted);
        total.merge(other.total);
        for (std::size_t order = 0; order < orders.size(); ++order)
            orders[order].merge(other.orders[order]);
    }
};

void record(const Exit& exit, AlbedoTally& tally) {
    if (exit.fate == Fate::lost) return;
    if (exit.fate == Fate::transmitted) {
        tally.transmitted.add(exit.weight);
        return;
    }
    (exit.fate == Fate::base ? tally.base : tally.direct).add(exit.weight);
    tally.total.add(exit.weight);
    if (exit.order >= 1 && exit.order <= 3)
        tally.orders[static_cast<std::size_t>(exit.order - 1)].add(exit.weight);
}

}  // namespace

AlbedoEstimate estimate_albedo(const StackWalk& stack, double cos_theta_o,
                               const RunOptions& options) {
    const Vec3 wo{std::sqrt(1.0 - cos_theta_o * cos_theta_o), 0.0, cos_theta_o};
    const auto tally = run_walks<AlbedoTally>(options, [&](RandomStream& random, AlbedoTally& sum) {
        record(stack.walk(wo, random), sum);
    });
    const auto count = static_cast<double>(tally.count);
    AlbedoEstimate result;
    result.samples = tally.count;
    result.direct = tally.direct.estimate(count);
    result.base = tally.base.estimate(count);
    result.transmitted = tally.transmitted.estimate(count);
    result.total = tally.total.estimate(count);
    for (std::size_t order = 0; order < 3; ++order)
        result.orders[order] = tally.orders[order].estimate(count);
    return result;
}

}  // namespace lacquer::simulator
