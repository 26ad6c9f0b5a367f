#include "study/error_tally.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace lacquer::study {

ErrorTally::ErrorTally(std::string subject, std::string model, double sure_errors)
    : error_{std::move(subject), std::move(model)}, sure_errors_{sure_errors} {}

bool ErrorTally::count(double difference, double standard_error, double weight) {
    // The mean of |noise| where noise is normal.
    static const double kMeanDeviation = std::sqrt(2.0 / std::numbers::pi);
    const double size = std::abs(difference);
    sum_ += weight * size;
    noise_ += weight * kMeanDeviation * standard_error;
    weights_ += weight;
    const double sure = std::max(size - sure_errors_ * standard_error, 0.0);
    if (sure <= error_.max) return false;
    error_.max = sure;
    return true;
}

ModelError ErrorTally::result() const {
    return result(weights_);
}

ModelError ErrorTally::result(double total) const {
    ModelError error = error_;
    error.mean = total > 0.0 ? sum_ / total : 0.0;
    error.noise = total > 0.0 ? noise_ / total : 0.0;
    return error;
}

}  // namespace lacquer::study
