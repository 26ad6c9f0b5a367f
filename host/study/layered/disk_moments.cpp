#include "study/layered/disk_moments.h"

#include <algorithm>
#include <cmath>

namespace lacquer::study {

void DiskMoments::add(double weight, const glm::dvec3& w) {
    const double r2 = w.x * w.x + w.y * w.y, weight2 = weight * weight;
    const std::array terms{1.0, w.x, w.x * w.x, r2, r2 * w.x, r2 * r2};
    plain_[0] += weight;
    plain_[1] += weight * w.x;
    plain_[2] += weight * r2;
    for (std::size_t k = 0; k < terms.size(); ++k) squared_[k] += weight2 * terms[k];
}

void DiskMoments::merge(const DiskMoments& other) {
    for (std::size_t k = 0; k < plain_.size(); ++k) plain_[k] += other.plain_[k];
    for (std::size_t k = 0; k < squared_.size(); ++k) squared_[k] += other.squared_[k];
}

Spread DiskMoments::spread(double count) const {
    Spread result;
    if (plain_[0] <= 0.0) return result;
    result.energy = plain_[0] / count;
    result.energy_error =
        std::sqrt(std::max(0.0, squared_[0] / count - result.energy * result.energy) / count);
    const double mean = plain_[1] / plain_[0];
    result.mean = mean;
    result.mean_error = std::sqrt(std::max(0.0, squared_[2] - 2.0 * mean * squared_[1] +
                                                    mean * mean * squared_[0])) /
                        plain_[0];
    const double variance = 0.5 * (plain_[2] / plain_[0] - mean * mean);
    if (variance <= 0.0) return result;
    result.width = std::sqrt(variance);
    // The variance is a ratio of sums; its error to first order, from the squared residuals of
    // ((r^2 - 2 mean x + mean^2) / 2 - variance).
    const double c = mean * mean - 2.0 * variance;
    const double residual = squared_[5] + 4.0 * mean * mean * squared_[2] + c * c * squared_[0] -
                            4.0 * mean * squared_[4] + 2.0 * c * squared_[3] -
                            4.0 * mean * c * squared_[1];
    result.width_error =
        0.5 * std::sqrt(std::max(residual, 0.0)) / plain_[0] / (2.0 * result.width);
    return result;
}

}  // namespace lacquer::study
