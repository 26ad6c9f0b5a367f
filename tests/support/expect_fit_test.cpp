// The helper that judges histograms: accepts a fit, and leaves a misfit where one can look at it.
#include "support/expect_fit.h"

#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace lacquer::test {
namespace {

constexpr double kSignificance = 0.01;

TEST(ExpectFit, AcceptsCountsNearTheirExpectation) {
    // Each a standard deviation off, chi-square 4 at 3 degrees of freedom.
    expect_fit(std::vector<double>{110, 90, 110, 90}, std::vector<double>(4, 100), kSignificance,
               "even");
}

TEST(ExpectFit, NamesTheFileOfAMisfit) {
    testing::TestPartResultArray failures;
    {
        const testing::ScopedFakeTestPartResultReporter reporter{
            testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &failures};
        expect_fit(std::vector<double>{140, 60}, std::vector<double>{100, 100}, kSignificance,
                   "lopsided");
    }
    ASSERT_EQ(failures.size(), 1);
    const std::string message = failures.GetTestPartResult(0).message();
    EXPECT_NE(message.find("lopsided: chi-square 32 at 1 degrees"), std::string::npos) << message;
    const std::size_t quote = message.find('"');
    ASSERT_NE(quote, std::string::npos) << message;
    std::ifstream file{message.substr(quote + 1, message.rfind('"') - quote - 1)};
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_EQ(text.str(), "cell,observed,expected,deviation\n0,140,100,4\n1,60,100,-4\n");
}

}  // namespace
}  // namespace lacquer::test
