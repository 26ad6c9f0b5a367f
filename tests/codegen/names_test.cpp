// Names, documentation and shape of the source survive in every language.
#include <gmock/gmock.h>

#include <regex>
#include <sstream>

#include "check.h"
#include "codegen/declarations.h"
#include "codegen/emit.h"
#include "codegen/text/print.h"
#include "codegen/text/tree.h"
#include "codegen/variants.h"

namespace lacquer::test {
namespace {

using codegen::Declaration;
using codegen::Form;
using codegen::ShaderFile;
using codegen::SourceModule;
using codegen::Target;
using testing::HasSubstr;

class Names : public testing::TestWithParam<Target> {
 protected:
    static std::vector<SourceModule> declarations_of(const ShaderFile& file) {
        const codegen::SourceTree tree{SHADER_SOURCE};
        const codegen::Level& level = codegen::level_from_name(file.level);
        return codegen::read_declarations(tree, std::string{level.source});
    }
};

const codegen::text::Statement* definition(const codegen::text::Statements& statements,
                                           const std::string& name, Target target) {
    for (const auto& statement : statements)
        if (definition_of(statement, codegen::dialect_of(target)).name == name) return &statement;
    return nullptr;
}

TEST_P(Names, EveryDeclarationIsDefinedUnderItsDocumentation) {
    for (const ShaderFile& file : files_of(GetParam(), Form::library)) {
        const auto statements =
            codegen::text::parse(file.contents, codegen::dialect_of(file.target));
        for (const SourceModule& module : declarations_of(file)) {
            for (const Declaration& declaration : module.declarations) {
                const auto* found = definition(statements, declaration.name, file.target);
                ASSERT_NE(found, nullptr) << declaration.name;
                for (const codegen::Parameter& parameter : declaration.parameters)
                    EXPECT_TRUE(mentions(found->head, parameter.name))
                        << declaration.name << " has lost its parameter " << parameter.name;
                for (const std::string& line : declaration.comment)
                    EXPECT_THAT(file.contents, HasSubstr(line + "\n"));
            }
        }
    }
}

TEST_P(Names, MembersOfStructsKeepTheirNames) {
    static const std::regex kMember{R"(\n    \w+ (\w+);)"};
    static const std::regex kStruct{R"(\nstruct (\w+) \{((?:\n    .*;)+)\n\};)"};
    for (const ShaderFile& file : files_of(GetParam(), Form::library)) {
        const auto statements =
            codegen::text::parse(file.contents, codegen::dialect_of(file.target));
        const codegen::SourceTree tree{SHADER_SOURCE};
        for (const SourceModule& module : declarations_of(file)) {
            const std::string& text = tree.text(module.file);
            for (std::sregex_iterator match{text.begin(), text.end(), kStruct}, end; match != end;
                 ++match) {
                const auto* found = definition(statements, (*match)[1], file.target);
                ASSERT_NE(found, nullptr);
                const std::string body = (*match)[2];
                for (std::sregex_iterator member{body.begin(), body.end(), kMember}, last;
                     member != last; ++member)
                    EXPECT_GT(count_mentions(*found, (*member)[1].str()), 0u)
                        << (*match)[1] << " has lost " << (*member)[1];
            }
        }
    }
}

std::vector<std::string> leftovers(const std::string& text) {
    static const std::regex kLeftover{
        R"(\b(_\d+|_e\d+|param(_\d+)?|indexable(_\d+)?|lq_selected\w*|local(_\d+)?|phi_\d+_|unnamed\w*|[A-Za-z]\w*_\d+)\b)"};
    const std::string code = without_comments(text);
    std::vector<std::string> found;
    for (std::sregex_iterator match{code.begin(), code.end(), kLeftover}, end; match != end;
         ++match)
        found.push_back(match->str());
    return found;
}

// What translators call things that have no name in the source. None is left today; a new
// construct in the shader source that leaves some is better rewritten there.
TEST_P(Names, NothingIsNamedByTheTranslator) {
    for (const ShaderFile& file : files_of(GetParam()))
        EXPECT_THAT(leftovers(file.contents), testing::IsEmpty()) << file.path;
}

// A name that is a word of some language is changed there: better not used in the source.
TEST_P(Names, NoNameIsAWordOfTheLanguage) {
    static const std::regex kEscaped{R"(\b(_[a-z]\w*|[a-z]\w*_)\b)"};
    for (const ShaderFile& file : files_of(GetParam())) {
        const std::string code = without_comments(file.contents);
        for (std::sregex_iterator match{code.begin(), code.end(), kEscaped}, end; match != end;
             ++match)
            ADD_FAILURE() << file.path << ": " << match->str();
    }
}

TEST_P(Names, NumbersAreShort) {
    // A float has at most nine significant digits.
    static const std::regex kLong{R"(\d\.\d{13,})"};
    for (const ShaderFile& file : files_of(GetParam()))
        EXPECT_FALSE(std::regex_search(without_comments(file.contents), kLong)) << file.path;
}

TEST_P(Names, LinesOfCodeFitTheColumns) {
    for (const ShaderFile& file : files_of(GetParam())) {
        std::istringstream lines{without_comments(file.contents)};
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), codegen::text::kColumns) << file.path << ": " << line;
    }
}

TEST_P(Names, HeadsSayWhatTheFileIs) {
    const codegen::SourceTree tree{SHADER_SOURCE};
    for (const ShaderFile& file : files_of(GetParam())) {
        const std::string head = file.contents.substr(0, 600);
        EXPECT_THAT(head, HasSubstr("// SPDX-License-Identifier: Apache-2.0\n"));
        EXPECT_THAT(head, HasSubstr("// Lacquer "));
        EXPECT_THAT(head, HasSubstr(file.level + ": "));
        EXPECT_THAT(head, HasSubstr("source sha256 "));
        if (file.form == Form::kernel) {
            EXPECT_THAT(head, HasSubstr("'" + file.kernel + "'"));
        }
    }
}

TEST_P(Names, LibrariesBindNothing) {
    static const std::regex kBinding{
        R"(\b(binding|register|buffer|uniform|cbuffer|var<\w+|main0?)\b|\[\[)"};
    for (const ShaderFile& file : files_of(GetParam(), Form::library)) {
        EXPECT_FALSE(std::regex_search(without_comments(file.contents), kBinding)) << file.path;
        EXPECT_TRUE(file.entry_points.empty());
        EXPECT_TRUE(file.bindings.empty());
    }
}

TEST(ConstructNames, NothingIsNamedByTheTranslator) {
    for (const ShaderFile& file : with_constructs().files)
        if (file.target != Target::spirv && file.kernel == "constructs") {
            EXPECT_THAT(leftovers(file.contents), testing::IsEmpty()) << file.contents;
        }
}

INSTANTIATE_TEST_SUITE_P(, Names, testing::ValuesIn(text_targets()), [](const auto& tested) {
    return std::string{codegen::target_name(tested.param)};
});

}  // namespace
}  // namespace lacquer::test
