// How far results are from the reference's.
#pragma once

#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

namespace lacquer {

// Below this magnitude errors are measured against it instead of the reference: relative errors of
// values nobody sees would say nothing.
inline constexpr double kRelativeFloor = 1e-3;

// Error of one query: the largest over its compared components. Both are infinite where a result,
// or the reference, is not finite.
struct QueryError {
    double absolute = 0.0;
    double relative = 0.0;  // |e| / max(|ref|, kRelativeFloor)
    int component = 0;      // the one with the largest relative error
};

// Compares the first `components` (1 to 4) of a result row.
QueryError query_error(const glm::dvec4& value, const glm::dvec4& reference, int components);

// Errors of many queries. Percentiles are by nearest rank: the smallest error that at least that
// share of the queries does not exceed.
struct ErrorSummary {
    std::uint64_t queries = 0;
    std::uint64_t non_finite = 0;  // queries with an infinite error
    double max_abs = 0.0, mean_abs = 0.0;
    double max_rel = 0.0, p999_rel = 0.0, median_rel = 0.0;
    std::size_t worst =
        0;  // index of the query with the largest relative error, the first of equals
};

ErrorSummary summarize(std::span<const QueryError> errors);

}  // namespace lacquer
