#include <gmock/gmock.h>

#include <array>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "cli/run_lacquer.h"
#include "core/file.h"
#include "core/version.h"
#include "support/temporary_folder.h"

namespace lacquer {
namespace {

using nlohmann::json;
using test::expect_failure;
using test::expect_success;
using test::kLambertian;
using test::kUsage;
using test::run_lacquer;
using test::TemporaryFolder;
using test::Words;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr double kPi = std::numbers::pi;

// Closed forms are met to the rounding of a few operations in double, or in float.
constexpr double kDoubleRounding = 1e-15;
constexpr double kFloatRounding = 5e-7;

constexpr std::array kCommands{"compare",     "bench", "eval",   "albedo", "interface",
                               "heightfield", "slice", "sphere", "export", "doctor"};

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream{text};
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream stream{line};
    for (std::string cell; std::getline(stream, cell, ',');) numbers.push_back(std::stod(cell));
    return numbers;
}

class Commands : public ::testing::Test {
 protected:
    Commands() : material_{(folder_ / "matte.json").string()} {
        write_file(material_, kLambertian);
    }

    TemporaryFolder folder_;
    std::string material_;
};

TEST(Help, OfEveryCommandShowsExamples) {
    for (const char* command : kCommands) {
        const ProcessResult result = run_lacquer({command, "--help"});
        expect_success(result);
        EXPECT_THAT(result.out, HasSubstr("Examples:\n  lacquer " + std::string{command}));
    }
}

TEST(Help, OfTheProgramListsTheCommands) {
    const ProcessResult result = run_lacquer({"--help"});
    expect_success(result);
    for (const char* command : kCommands) EXPECT_THAT(result.out, HasSubstr(command));
}

TEST(Version, IsPrinted) {
    const ProcessResult result = run_lacquer({"--version"});
    expect_success(result);
    EXPECT_EQ(result.out, std::string{"lacquer "} + kVersion + "\n");
}

TEST_F(Commands, EvalPrintsTheClosedFormOfALambertianBase) {
    const ProcessResult result =
        run_lacquer({"eval", "--material", material_, "--queries", "-"},
                    "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n0,0,1,0,0,1\n0,0,-1,0,0,1\n1,0,0.0,0,0,1\n");
    expect_success(result);
    const std::vector<std::string> lines = lines_of(result.out);
    ASSERT_THAT(lines, SizeIs(4));
    EXPECT_EQ(lines[0], "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,f_r,f_g,f_b,pdf");
    EXPECT_THAT(lines[3], ::testing::StartsWith("1,0,0.0,0,0,1,"));
    const std::vector<double> row = numbers_of(lines[1]);
    ASSERT_THAT(row, SizeIs(10));
    EXPECT_NEAR(row[6], 0.5 / kPi, kDoubleRounding);
    EXPECT_NEAR(row[7], 0.25 / kPi, kDoubleRounding);
    EXPECT_NEAR(row[8], 1.0 / kPi, kDoubleRounding);
    EXPECT_NEAR(row[9], 1.0 / kPi, kDoubleRounding);
    EXPECT_EQ(numbers_of(lines[2])[6], 0.0);
}

TEST_F(Commands, EvalGivesTheSameOnAnotherBackendToFloatPrecision) {
    const ProcessResult result =
        run_lacquer({"eval", "--material", material_, "--queries", "-", "--backend", "cpp"},
                    "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n0,0.6,0.8,0,0,1\n");
    expect_success(result);
    const std::vector<double> row = numbers_of(lines_of(result.out).at(1));
    EXPECT_NEAR(row.at(6), 0.5 / kPi, kFloatRounding);
    EXPECT_NEAR(row.at(9), 0.8 / kPi, kFloatRounding);
}

TEST_F(Commands, EvalReadsAFileAsItReadsTheStandardInput) {
    const std::string queries = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n0,0.6,0.8,0,0,1\n";
    write_file(folder_ / "q.csv", queries);
    EXPECT_EQ(
        run_lacquer({"eval", "--material", material_, "--queries", (folder_ / "q.csv").string()})
            .out,
        run_lacquer({"eval", "--material", material_, "--queries", "-"}, queries).out);
}

TEST_F(Commands, AlbedoOfALambertianBaseIsItsAlbedo) {
    const ProcessResult result =
        run_lacquer({"albedo", "--material", material_, "--cos", "1,0.5,0.01", "--json"});
    expect_success(result);
    const json rows = json::parse(result.out).at("rows");
    ASSERT_THAT(rows, SizeIs(3));
    EXPECT_EQ(rows[2].at("cos"), 0.01);
    for (const json& row : rows) {
        EXPECT_NEAR(row.at("base")[1].get<double>(), 0.25, kFloatRounding);
        EXPECT_EQ(row.at("direct")[1], 0.0);
        EXPECT_EQ(row.at("transmitted")[1], 0.0);
        EXPECT_EQ(row.at("total")[1], row.at("base")[1]);
    }
}

TEST_F(Commands, AlbedoPrintsATable) {
    const ProcessResult result = run_lacquer({"albedo", "--material", material_, "--cos", "1"});
    expect_success(result);
    EXPECT_THAT(result.out, HasSubstr("transmitted"));
    EXPECT_THAT(result.out, HasSubstr("0.50000 0.25000 1.00000"));
}

TEST_F(Commands, BenchMeasuresRatesAndRatios) {
    const ProcessResult result = run_lacquer({"bench", "--backend", "cpp", "--material", material_,
                                              "--queries", "10000", "--runs", "3", "--json"});
    expect_success(result);
    const json parsed = json::parse(result.out);
    EXPECT_EQ(parsed.at("queries"), 10000);
    const json& backend = parsed.at("backends").at(0);
    EXPECT_EQ(backend.at("name"), "cpp");
    EXPECT_GT(backend.at("queries_per_second").get<double>(), 0.0);
    EXPECT_GT(backend.at("ratio_to_copy").get<double>(), 0.0);
    EXPECT_EQ(backend.at("ratio_to_plain"), 1.0);
}

TEST_F(Commands, BenchMeasuresTheSimulator) {
    const ProcessResult result = run_lacquer({"bench", "--simulator", "--runs", "1", "--json"});
    expect_success(result);
    const json parsed = json::parse(result.out);
    EXPECT_THAT(parsed.at("backends"), SizeIs(0));
    const json& rates = parsed.at("simulator");
    ASSERT_THAT(rates, SizeIs(6));
    for (const json& rate : rates) {
        EXPECT_EQ(rate.at("eta"), 1.5);
        EXPECT_GT(rate.at("walks_per_core_second").get<double>(), 0.0);
    }
    EXPECT_EQ(rates[0].at("ndf"), "ggx");
    EXPECT_EQ(rates[0].at("alpha"), 0.1);
    expect_failure(run_lacquer({"bench", "--simulator", "--backend", "cpp"}), kUsage,
                   {"--simulator", "--backend"});
}

TEST_F(Commands, BenchTakesASingleQuery) {
    expect_success(run_lacquer({"bench", "--backend", "cpp", "--queries", "1", "--runs", "1"}));
}

}  // namespace
}  // namespace lacquer
