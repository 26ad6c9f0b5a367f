#include "support/expect_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>

#include "support/chi_square.h"

namespace lacquer::test {

namespace {

namespace fs = std::filesystem;

// One test may fail several times.
fs::path next_file() {
    static int count = 0;
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string{test->test_suite_name()} + "." + test->name() + "." +
                       std::to_string(++count) + ".csv";
    std::replace(name.begin(), name.end(), '/', '_');  // of parameterised tests
    return fs::path{LACQUER_TEST_OUTPUT} / name;
}

// What a cell adds to chi-square is this squared.
std::vector<double> deviations(std::span<const double> observed, std::span<const double> expected) {
    std::vector<double> result;
    for (std::size_t cell = 0; cell < observed.size(); ++cell)
        result.push_back((observed[cell] - expected[cell]) /
                         std::sqrt(std::max(expected[cell], 1.0)));
    return result;
}

}  // namespace

fs::path dump_csv(const std::vector<CsvColumn>& columns) {
    const fs::path path = next_file();
    fs::create_directories(path.parent_path());
    std::ofstream file{path};
    file << "cell";
    for (const CsvColumn& column : columns) file << "," << column.title;
    file << std::setprecision(10);
    for (std::size_t cell = 0; cell < columns.front().values.size(); ++cell) {
        file << "\n" << cell;
        for (const CsvColumn& column : columns) file << "," << column.values[cell];
    }
    file << "\n";
    return path;
}

void expect_fit(std::span<const double> observed, std::span<const double> expected,
                double significance, const std::string& what) {
    const ChiSquare fit = chi_square(observed, expected);
    if (fit.p_value() > significance) return;
    const fs::path path = dump_csv({{"observed", {observed.begin(), observed.end()}},
                                    {"expected", {expected.begin(), expected.end()}},
                                    {"deviation", deviations(observed, expected)}});
    ADD_FAILURE() << what << ": chi-square " << fit.statistic << " at " << fit.degrees_of_freedom
                  << " degrees of freedom, p-value " << fit.p_value() << " below " << significance
                  << "; cells in " << path;
}

}  // namespace lacquer::test
