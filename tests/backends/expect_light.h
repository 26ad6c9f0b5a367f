// What every backend promises of its results.
#pragma once

#include "backends/jobs.h"

namespace lacquer::test {

// Expects finite numbers, none of them negative but in directions. Stops at the fifth failure, the
// rest would say no more.
void expect_no_nan_infinity_or_negative_light(const OwnedJob& owned, const JobResult& result);

// The material and the inputs of a query, for messages.
std::string describe(const OwnedJob& owned, std::size_t query);

}  // namespace lacquer::test
