// `lacquer compare --suite NAME` for the studies of papers.
#pragma once

#include <filesystem>
#include <string>

#include "cli/simulate_options.h"
#include "study/suite.h"

namespace lacquer {

// The suite of that name, or nullptr for `backends`, the comparison of backends. Throws UsageError
// listing all names.
const study::Suite* suite_from_name(const std::string& name, const std::string& backends);

// Throws UsageError where an option was given that only the other kind of suite takes.
void require_suite_options(const CLI::App& command, const std::string& suite, bool is_study);

// Makes the suite's figures, writes a report unless `report` is empty, and prints the errors.
void run_study_suite(const study::Suite& suite, const SimulateOptions& simulate,
                     const std::filesystem::path& report, bool json);

}  // namespace lacquer
