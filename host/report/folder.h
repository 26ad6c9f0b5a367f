// The report as a folder of files.
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include "compare/compare.h"

namespace lacquer {

// Makes `folder` and throws Error where nothing can be written there: what a command checks before
// it computes.
void require_report_folder(const std::filesystem::path& folder);

// Writes report.html, compare.json, junit.xml, and below exr/MATERIAL/: the sphere by the reference
// and by each backend, and the slices by the reference and by backends that failed on it. Each file
// appears whole or not at all.
void write_report(const CompareResult& result, const std::filesystem::path& folder);

}  // namespace lacquer
