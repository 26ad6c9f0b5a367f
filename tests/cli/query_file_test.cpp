#include "cli/query_file.h"

#include <gmock/gmock.h>

#include "core/error.h"

namespace lacquer {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::SizeIs;

constexpr const char* kHeader = "wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\n";

std::string message_of(const std::string& text) {
    try {
        parse_queries(text, "q.csv");
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::string message_of_row(const std::string& row) {
    return message_of(kHeader + row);
}

TEST(ParseQueries, ReadsEveryRowAndKeepsItsText) {
    const auto rows =
        parse_queries(std::string{kHeader} + "0, 0.6,0.8,0,0,1\n1e0,0,0,0,-1,0\n", "q");
    ASSERT_THAT(rows, SizeIs(2));
    EXPECT_EQ(rows[0].text, "0, 0.6,0.8,0,0,1");
    EXPECT_EQ(rows[0].wi, glm::dvec3(0.0, 0.6, 0.8));
    EXPECT_EQ(rows[1].wo, glm::dvec3(0.0, -1.0, 0.0));
}

TEST(ParseQueries, TakesCarriageReturnsAndMissingLastNewlines) {
    const auto rows = parse_queries("wi_x,wi_y,wi_z,wo_x,wo_y,wo_z\r\n0,0,1,0,0,1\r\n\r\n", "q");
    ASSERT_THAT(rows, SizeIs(1));
    EXPECT_EQ(rows[0].text, "0,0,1,0,0,1");
    EXPECT_THAT(parse_queries(std::string{kHeader} + "0,0,1,0,0,1", "q"), SizeIs(1));
}

TEST(ParseQueries, NamesTheLineAndColumnOfWhatIsNoNumber) {
    for (const char* bad : {"x", "", "1.0.0", "1 2", "nan", "inf", "0x1", "1e999"})
        EXPECT_THAT(message_of_row("0,0,1,0,0,1\n0,0,1," + std::string{bad} + ",0,1\n"),
                    AllOf(HasSubstr("q.csv:3:"), HasSubstr("column 4 (wo_x)")))
            << bad;
}

TEST(ParseQueries, CountsTheColumnsOfARow) {
    EXPECT_THAT(message_of_row("0,0,1,0,0\n"),
                AllOf(HasSubstr("q.csv:2:"), HasSubstr("5 columns")));
    EXPECT_THAT(message_of_row("0,0,1,0,0,1,0\n"), HasSubstr("7 columns"));
    EXPECT_THAT(message_of_row("0,0,1,0,0,1\n\n0,0,1,0,0,1\n"), HasSubstr("q.csv:3:"));
}

TEST(ParseQueries, WantsItsHeader) {
    EXPECT_THAT(message_of("0,0,1,0,0,1\n"), AllOf(HasSubstr("q.csv:1:"), HasSubstr("column 1")));
    EXPECT_THAT(message_of("wi_x,wi_y,wi_z,wo_x,wo_y\n"), HasSubstr("column 6"));
    EXPECT_THAT(message_of("wi_x,wi_y,wi_z,wo_x,wo_y,wo_z,f\n"), HasSubstr("7 columns"));
    EXPECT_THAT(message_of(kHeader), HasSubstr("no queries"));
    EXPECT_THAT(message_of(""), HasSubstr("empty"));
}

TEST(ParseQueries, WantsUnitDirectionsWithinTheTolerance) {
    EXPECT_EQ(message_of_row("0,0,1.000009,0,0,1\n"), "");
    EXPECT_THAT(message_of_row("0,0,1.00002,0,0,1\n"),
                AllOf(HasSubstr("wi_x"), HasSubstr("q.csv:2:")));
    EXPECT_THAT(message_of_row("0,0,1,0,0,0\n"), HasSubstr("wo_x"));
}

}  // namespace
}  // namespace lacquer
