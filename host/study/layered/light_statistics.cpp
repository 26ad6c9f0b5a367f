#include "study/layered/light_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/stack.h"
#include "study/even_point.h"

namespace lacquer::study {

namespace {

constexpr int kPoints = 1024;

double mean_of(const glm::dvec3& rgb) {
    return (rgb.x + rgb.y + rgb.z) / 3.0;
}

// Of positions on the disk at distance r from its middle: sums of weight times 1, x and r^2, and of
// squared weight times 1, x, x^2, r^2, r^2 x and r^4.
struct DiskMoments {
    std::array<double, 3> plain{};
    std::array<double, 6> squared{};

    void add(double weight, const glm::dvec3& w) {
        const double r2 = w.x * w.x + w.y * w.y, weight2 = weight * weight;
        const std::array terms{1.0, w.x, w.x * w.x, r2, r2 * w.x, r2 * r2};
        plain[0] += weight;
        plain[1] += weight * w.x;
        plain[2] += weight * r2;
        for (std::size_t k = 0; k < terms.size(); ++k) squared[k] += weight2 * terms[k];
    }

    void merge(const DiskMoments& other) {
        for (std::size_t k = 0; k < plain.size(); ++k) plain[k] += other.plain[k];
        for (std::size_t k = 0; k < squared.size(); ++k) squared[k] += other.squared[k];
    }

    Spread spread(double count) const {
        Spread result;
        if (plain[0] <= 0.0) return result;
        result.energy = plain[0] / count;
        result.energy_error =
            std::sqrt(std::max(0.0, squared[0] / count - result.energy * result.energy) / count);
        const double mean = plain[1] / plain[0];
        const double variance = 0.5 * (plain[2] / plain[0] - mean * mean);
        if (variance <= 0.0) return result;
        result.width = std::sqrt(variance);
        // The variance is a ratio of sums; its error to first order, from the squared residuals of
        // ((r^2 - 2 mean x + mean^2) / 2 - variance).
        const double c = mean * mean - 2.0 * variance;
        const double residual = squared[5] + 4.0 * mean * mean * squared[2] + c * c * squared[0] -
                                4.0 * mean * squared[4] + 2.0 * c * squared[3] -
                                4.0 * mean * c * squared[1];
        result.width_error =
            0.5 * std::sqrt(std::max(residual, 0.0)) / plain[0] / (2.0 * result.width);
        return result;
    }
};

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
