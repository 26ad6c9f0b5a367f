// What a bake tells people: the accuracy table of tables/README.md, and a page of plots.
#pragma once

#include <string>
#include <vector>

#include "bake/accuracy.h"
#include "bake/truncation.h"

namespace lacquer::bake {

// One line of the accuracy table.
struct TableRecord {
    std::string name;
    std::size_t bytes = 0;
    double seconds = 0.0;
    ErrorSummary on_grid;
};

struct CheckRecord {
    std::string name;
    ErrorSummary off_grid;
};

struct BakeRecord {
    std::string command;
    BakeSettings settings;
    std::size_t points = 0;         // random points of each check
    std::size_t point_samples = 0;  // walks of each
    std::vector<TableRecord> tables;
    std::vector<CheckRecord> checks;
    std::vector<Truncation> truncations;  // for the page only
};

// Markdown between the markers kAccuracyBegin and kAccuracyEnd.
std::string accuracy_text(const BakeRecord& record);

inline constexpr std::string_view kAccuracyBegin = "<!-- accuracy: written by lacquer bake -->";
inline constexpr std::string_view kAccuracyEnd = "<!-- end of accuracy -->";

// `readme` with what lies between the markers replaced. Throws Error where a marker is missing.
std::string with_accuracy(const std::string& readme, const std::string& text);

// A page, complete in itself, with plots of the statistics: de Dinechin and Belcour 2022, figures 3
// and 5; Belcour 2018, figures 3 to 6 and 21.
std::string report_page(const EnergyTables& tables, const BakeRecord& record);

}  // namespace lacquer::bake
