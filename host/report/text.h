// The comparison as text: a table for a terminal, and one in Markdown for a README.
#pragma once

#include <filesystem>
#include <string>

#include "compare/compare.h"

namespace lacquer {

// One row per backend: its largest errors over all materials, its throughput and device. Reasons of
// backends that were skipped or broke down stand in the device's place.
std::string summary_table(const CompareResult& result);

// The accuracy of each backend that ran, in Markdown, without timings: the same results give the
// same bytes.
std::string accuracy_markdown(const CompareResult& result);

// Replaces what stands between kMarkdownBegin and kMarkdownEnd in `file`. Throws Error where the
// file lacks the two lines.
void update_markdown(const std::filesystem::path& file, const std::string& markdown);

inline constexpr std::string_view kMarkdownBegin =
    "<!-- accuracy: written by `lacquer compare --update-readme` -->";
inline constexpr std::string_view kMarkdownEnd = "<!-- end of accuracy -->";

}  // namespace lacquer
