#include "study/layered/light_statistics.h"

#include <algorithm>
#include <cmath>

#include "simulator/stack.h"
#include "study/even_point.h"

namespace lacquer::study {

namespace {

constexpr int kPoints = 1024;

double mean_of(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0;
}

struct StatisticsTally {
    DiskMoments all, base;
    std::uint64_t count = 0;

    void merge(const StatisticsTally& other) {
        all.merge(other.all);
        base.merge(other.base);
    }
};

glm::dvec3 viewer_at(double cos_theta_o) {
    return {std::sqrt(1.0 - cos_theta_o * cos_theta_o), 0.0, cos_theta_o};
}

}  // namespace

LightStatistics simulate_statistics(const Material& material, double cos_theta_o,
                                    std::uint64_t walks, const StudyRun& run,
                                    const std::string& name) {
    const simulator::StackWalk stack{material};
    const glm::dvec3 wo = viewer_at(cos_theta_o);
    const auto tally = simulator::run_walks<StatisticsTally>(
        run.options(walks, name), [&](simulator::RandomStream& random, StatisticsTally& sum) {
            const simulator::Exit exit = stack.walk(wo, random);
            if (exit.fate != simulator::Fate::direct && exit.fate != simulator::Fate::base) return;
            sum.all.add(mean_of(exit.weight), exit.direction);
            if (exit.fate == simulator::Fate::base)
                sum.base.add(mean_of(exit.weight), exit.direction);
        });
    const auto count = static_cast<double>(tally.count);
    return {tally.all.spread(count), tally.base.spread(count)};
}

LightStatistics model_statistics(const ModelLight& model, double cos_theta_o) {
    const glm::dvec3 wo = viewer_at(cos_theta_o);
    DiskMoments all, base;
    for (int n = 0; n < kPoints; ++n) {
        const reference::Sample sample = model.sample(wo, even_point(n));
        if (sample.pdf <= 0.0 || sample.wi.z <= 0.0) continue;
        all.add(mean_of(sample.weight), sample.wi);
        base.add(mean_of(model.base(sample.wi, wo)) * sample.wi.z / sample.pdf, sample.wi);
    }
    const reference::Albedo albedo = model.albedo(wo);
    LightStatistics result{all.spread(kPoints), base.spread(kPoints)};
    result.all.energy = mean_of(albedo.direct + albedo.base);
    result.base.energy = mean_of(albedo.base);
    return result;
}

}  // namespace lacquer::study
