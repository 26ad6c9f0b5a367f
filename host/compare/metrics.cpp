#include "compare/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace lacquer {

namespace {

// The value of nearest rank `share` in (0, 1]; reorders `values`, which must not be empty.
double percentile(std::vector<double>& values, double share) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * double(values.size())));
    const auto position =
        values.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(rank, 1) - 1);
    std::nth_element(values.begin(), position, values.end());
    return *position;
}

}  // namespace

QueryError query_error(const glm::dvec4& value, const glm::dvec4& reference, int components) {
    QueryError error;
    for (int i = 0; i < components; ++i) {
        double absolute = std::abs(value[i] - reference[i]);
        if (!std::isfinite(value[i]) || !std::isfinite(reference[i]))
            absolute = std::numeric_limits<double>::infinity();
        const double scale = std::isfinite(reference[i]) ? std::abs(reference[i]) : 0.0;
        const double relative = absolute / std::max(scale, kRelativeFloor);
        error.absolute = std::max(error.absolute, absolute);
        if (relative <= error.relative) continue;
        error.relative = relative;
        error.component = i;
    }
    return error;
}

ErrorSummary summarize(std::span<const QueryError> errors) {
    ErrorSummary summary{.queries = errors.size()};
    if (errors.empty()) return summary;
    std::vector<double> relative;
    relative.reserve(errors.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const QueryError& error = errors[i];
        relative.push_back(error.relative);
        sum += error.absolute;
        summary.max_abs = std::max(summary.max_abs, error.absolute);
        if (std::isinf(error.absolute)) ++summary.non_finite;
        if (error.relative > errors[summary.worst].relative) summary.worst = i;
    }
    summary.mean_abs = sum / double(errors.size());
    summary.max_rel = errors[summary.worst].relative;
    summary.p999_rel = percentile(relative, 0.999);
    summary.median_rel = percentile(relative, 0.5);
    return summary;
}

}  // namespace lacquer
