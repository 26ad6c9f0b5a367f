#include "study/layered/error_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace lacquer::study {

ErrorSizes::ErrorSizes(std::string subject, std::string model)
    : tally_{std::move(subject), std::move(model)} {}

double ErrorSizes::quantile(double share) const {
    if (sizes_.empty()) return 0.0;
    std::vector<double> sorted;
    for (const double size : sizes_) sorted.push_back(std::abs(size));
    std::ranges::sort(sorted);
    const double rank = std::ceil(share * static_cast<double>(sorted.size()));
    return sorted[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

std::vector<std::string> ErrorSizes::row() const {
    const ModelError error = result();
    return {error.subject,
            error.model,
            fmt::format("{:.4f}", error.mean),
            fmt::format("{:.4f}", quantile(0.95)),
            fmt::format("{:.4f}", error.max),
            fmt::format("{:.4f}", error.noise)};
}

std::vector<std::string> error_columns(const std::string& what, const std::string& model) {
    return {what, model, "mean", "95 % below", "max", "noise"};
}

}  // namespace lacquer::study
