#include "cli/run_lacquer.h"

namespace lacquer::test {

ProcessResult run_lacquer(const Words& arguments, const std::string& input) {
    return run_process(LACQUER_PROGRAM, arguments, input);
}

void expect_failure(const ProcessResult& result, int exit_code, const Words& parts) {
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_EQ(result.out, "");
    EXPECT_THAT(result.err, ::testing::StartsWith("lacquer: "));
    for (const std::string& part : parts) EXPECT_THAT(result.err, ::testing::HasSubstr(part));
}

void expect_success(const ProcessResult& result) {
    EXPECT_EQ(result.exit_code, 0) << result.err;
}

}  // namespace lacquer::test
