// The comparison as one HTML file that needs nothing else: pictures, styles and charts are in it.
#pragma once

#include <string>

#include "compare/compare.h"

namespace lacquer {

// Where and when the comparison ran.
struct ReportEnvironment {
    std::string processor;
    std::string system;
    std::string date;  // UTC
};

ReportEnvironment current_environment();

// Throws Error where `result` was made without keep_values: there would be no pictures.
std::string report_html(const CompareResult& result, const ReportEnvironment& environment);

}  // namespace lacquer
