// Chi-square tests whose cells can be looked at when they fail.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lacquer::test {

// A column of a CSV file.
struct CsvColumn {
    std::string title;
    std::vector<double> values;
};

// Writes columns of equal length, numbered by `cell`, to a file of the running test's own in the
// build folder's test_output/, and returns its path.
std::filesystem::path dump_csv(const std::vector<CsvColumn>& columns);

// That counts per cell fit their expectations at this significance (see chi_square.h). A misfit is
// a failure of the test, which names the file with both histograms.
void expect_fit(std::span<const double> observed, std::span<const double> expected,
                double significance, const std::string& what);

}  // namespace lacquer::test
