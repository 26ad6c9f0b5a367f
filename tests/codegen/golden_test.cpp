// The files are what they were: what changes here changes for every user, and is to be looked at.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "check.h"
#include "core/file.h"

namespace lacquer::test {
namespace {

using codegen::Form;
using codegen::ShaderFile;
using codegen::Target;

bool updating() {
    return std::getenv("UPDATE_GOLDEN") != nullptr;
}

// The kernel that stands for all others, and the library, of the level that stands for all others.
bool is_kept(const ShaderFile& file) {
    return file.level == "plain" && (file.form == Form::library || file.kernel == "eval");
}

std::string first_difference(const std::string& expected, const std::string& actual) {
    std::istringstream expected_lines{expected};
    std::istringstream actual_lines{actual};
    std::string was;
    std::string is;
    for (int line = 1;; ++line) {
        const bool has_expected = static_cast<bool>(std::getline(expected_lines, was));
        const bool has_actual = static_cast<bool>(std::getline(actual_lines, is));
        if (!has_expected && !has_actual) return "no line";
        if (!has_expected) was = "(nothing)";
        if (!has_actual) is = "(nothing)";
        if (was != is) return fmt::format("line {}\n  was: {}\n  is:  {}", line, was, is);
    }
}

class Golden : public testing::TestWithParam<Target> {};

TEST_P(Golden, FilesAreWhatTheyWere) {
    for (const ShaderFile& file : files_of(GetParam())) {
        if (!is_kept(file)) continue;
        const std::filesystem::path golden = std::filesystem::path{EXPECTED} / file.path;
        if (updating()) {
            std::filesystem::create_directories(golden.parent_path());
            write_file(golden, file.contents);
            continue;
        }
        const std::string expected = read_file(golden);
        EXPECT_TRUE(expected == file.contents)
            << file.path << " differs first in " << first_difference(expected, file.contents)
            << "\nIf that is meant, write all of them anew with"
            << "\n  UPDATE_GOLDEN=1 ctest --preset release -R Golden"
            << "\nand read the difference before committing it.";
    }
}

INSTANTIATE_TEST_SUITE_P(, Golden, testing::ValuesIn(text_targets()), [](const auto& tested) {
    return std::string{codegen::target_name(tested.param)};
});

}  // namespace
}  // namespace lacquer::test
