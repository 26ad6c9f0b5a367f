// The comparison as JSON, for other programs. The shape is stable; keys may be added.
#pragma once

#include <string>

#include "compare/compare.h"

namespace lacquer {

// {"version", "model", "suite", "reference": {"device", "queries_per_second"}, "backends":
// [{"name", "status": "passed|failed|skipped", "reason", "device", "tolerance": {"max_rel",
// "median_rel"}, "materials": [{"name", "passed", "queries", "non_finite", "max_abs", "mean_abs",
// "max_rel", "p999_rel", "median_rel", "worst": {"wi", "wo", "grid", "component", "value",
// "reference", "replay"}, "queries_per_second"}]}]}. An error that is not finite is null.
std::string compare_json(const CompareResult& result);

}  // namespace lacquer
