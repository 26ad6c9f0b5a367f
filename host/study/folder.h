// A study as a folder of files.
#pragma once

#include <filesystem>

#include "study/suite.h"

namespace lacquer::study {

// Writes report.html, study.json, and below pictures/FIGURE/ every picture as PNG and EXR. The
// folder exists and can be written to (see require_report_folder).
void write_study(const StudyResult& result, const std::filesystem::path& folder);

}  // namespace lacquer::study
