// The comparison as JUnit XML, for continuous integration.
#pragma once

#include <string>

#include "compare/compare.h"

namespace lacquer {

// One test suite per backend, one test case per material. A skipped or broken backend has one case
// for each material too, skipped or in error, so that their number does not depend on the machine.
std::string compare_junit(const CompareResult& result);

}  // namespace lacquer
