// What is chosen at export for levels that shade stacks: how many layers, how many lobes.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>

#include "check.h"
#include "codegen/compile.h"
#include "codegen/emit.h"
#include "codegen/text/print.h"
#include "codegen/variants.h"
#include "core/error.h"

namespace lacquer::test {
namespace {

using codegen::Form;
using codegen::Package;
using codegen::ShaderFile;
using codegen::StackChoices;
using codegen::Target;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

// The libraries of both levels of stacks in GLSL.
codegen::Request request_of(const StackChoices& stacks) {
    codegen::Request request;
    request.source_root = SHADER_SOURCE;
    request.targets = {Target::glsl450};
    request.forms = {Form::library};
    request.levels = {"stack", "stack_symmetric"};
    request.stacks = stacks;
    return request;
}

// In every language, for as little as can be chosen, and for as much; each generated once.
const Package& least() {
    static const Package package = [] {
        codegen::Request request = request_of({codegen::kMinLayers, codegen::kMinLobes});
        request.targets.clear();
        return codegen::generate(request);
    }();
    return package;
}
const Package& most() {
    static const Package package = [] {
        codegen::Request request = request_of({codegen::kMaxLayers, codegen::kMaxLobes});
        request.targets.clear();
        return codegen::generate(request);
    }();
    return package;
}

TEST(StackChoices, EveryLanguageTakesTheLeastAndTheMost) {
    for (const Package* package : {&least(), &most()}) {
        EXPECT_EQ(package->files.size(), 2 * text_targets().size());
        for (const ShaderFile& file : package->files)
            EXPECT_EQ(complaint(file), "") << file.path << ", " << package->stacks.max_layers;
    }
}

// Light waits in three rows behind each level and before the first; a level has four rows of
// shares; and a layer has two levels, since its medium may scatter.
TEST(StackChoices, ArraysHoldTheLayersChosen) {
    for (const Package* package : {&least(), &most()}) {
        const int levels = 2 * package->stacks.max_layers;
        for (const ShaderFile& file : package->files) {
            if (file.target != Target::glsl450) continue;
            EXPECT_THAT(file.contents, AllOf(HasSubstr(fmt::format("waiting[{}]", 3 * levels + 3)),
                                             HasSubstr(fmt::format("shares[{}]", 4 * levels))))
                << file.path;
        }
    }
}

TEST(StackChoices, HeadsNameThem) {
    for (const ShaderFile& file : least().files)
        EXPECT_THAT(file.contents,
                    HasSubstr("Chosen at export: LQ_MAX_LAYERS 1, LQ_STACK_LOBES 2."))
            << file.path;
}

TEST(StackChoices, KernelsTakeTheRowsOfTheLayersChosen) {
    const codegen::SourceTree tree{SHADER_SOURCE};
    const std::string file = "kernels/eval.comp";
    const auto text_of = [&](const StackChoices& stacks) {
        const std::string preamble =
            codegen::level_preamble(codegen::level_from_name("stack"), stacks);
        const codegen::Words words =
            codegen::compile(tree, file, tree.text(file), {codegen::Stage::compute, preamble});
        return print(codegen::emit_glsl(words, Target::glsl450));
    };
    EXPECT_THAT(text_of({8, 3}), AllOf(HasSubstr("* 59u"), Not(HasSubstr("* 17u"))));
    EXPECT_THAT(text_of({2, 3}), AllOf(HasSubstr("* 17u"), Not(HasSubstr("* 59u"))));
}

std::map<std::string, std::size_t> instruction_counts(const Package& package) {
    std::map<std::string, std::size_t> counts;
    for (const ShaderFile& file : package.files)
        for (const codegen::Function& function : file.functions)
            if (function.instruction_count) counts[function.name] = *function.instruction_count;
    return counts;
}

// Of all that asks for lobes: preparing a surface and adding up its albedo do not.
TEST(StackChoices, FewerLobesCostFewerInstructions) {
    const std::map<std::string, std::size_t> two = instruction_counts(least());
    const std::map<std::string, std::size_t> three =
        instruction_counts(codegen::generate(request_of({codegen::kMinLayers, 3})));
    for (const std::string level : {"lq_stack_", "lq_stack_symmetric_"})
        for (const char* verb : {"view", "view_eval_cos", "eval", "eval_cos", "sample", "pdf"}) {
            const std::size_t less = two.at(level + verb), more = three.at(level + verb);
            EXPECT_LT(less, more) << level << verb;
            fmt::print("{}{}: {} instead of {}\n", level, verb, less, more);
        }
}

TEST(StackChoices, LeaveOtherLevelsAsTheyAre) {
    codegen::Request request = request_of({2, 2});
    request.levels = {"plain", "coated"};
    const Package chosen = codegen::generate(request);
    request.stacks = {};
    const Package usual = codegen::generate(request);
    ASSERT_EQ(chosen.files.size(), usual.files.size());
    for (std::size_t i = 0; i < usual.files.size(); ++i)
        EXPECT_TRUE(chosen.files[i].contents == usual.files[i].contents) << usual.files[i].path;
}

TEST(StackChoices, OutOfRangeAreNamedWithTheRange) {
    const auto message_of = [](const StackChoices& stacks) {
        try {
            codegen::generate(request_of(stacks));
        } catch (const UsageError& error) {
            return std::string{error.what()};
        }
        return std::string{};
    };
    for (const int layers : {-1, 0, 33})
        EXPECT_THAT(message_of({layers, 3}),
                    AllOf(HasSubstr("max-layers"), HasSubstr(std::to_string(layers)),
                          HasSubstr("[1, 32]")));
    for (const int lobes : {1, 4})
        EXPECT_THAT(
            message_of({8, lobes}),
            AllOf(HasSubstr("stack-lobes"), HasSubstr(std::to_string(lobes)), HasSubstr("[2, 3]")));
}

}  // namespace
}  // namespace lacquer::test
