// Tidying text does not change what it computes: compiled again and optimised, it has the
// operations of the module that it was translated from, each as often.
#include <gmock/gmock.h>

#include <cstring>
#include <map>
#include <set>
#include <spirv-tools/optimizer.hpp>

#include "check.h"
#include "codegen/naga.h"
#include "codegen/spirv_module.h"

namespace lacquer::test {
namespace {

using codegen::Form;
using codegen::ShaderFile;
using codegen::SourceTree;
using codegen::Target;
using codegen::Words;

using Operations = std::map<std::string, int>;

// How values are named, moved and taken apart differs between writers; what is computed does not.
const std::set<spv::Op> kMoves{spv::OpAccessChain,
                               spv::OpLoad,
                               spv::OpStore,
                               spv::OpVariable,
                               spv::OpCompositeConstruct,
                               spv::OpVectorShuffle,
                               spv::OpCompositeInsert,
                               spv::OpCompositeExtract,
                               spv::OpLabel,
                               spv::OpUnreachable,
                               spv::OpBitcast,
                               spv::OpFunction,
                               spv::OpFunctionEnd,
                               spv::OpFunctionParameter,
                               spv::OpBranch,
                               spv::OpReturn,
                               spv::OpReturnValue,
                               spv::OpCopyObject};

// Operations within functions, counted, after every call is inlined and all is optimised.
Operations operations(const Words& words) {
    spvtools::Optimizer optimizer{SPV_ENV_VULKAN_1_1};
    optimizer.RegisterPerformancePasses();
    Words optimised;
    EXPECT_TRUE(optimizer.Run(words.data(), words.size(), &optimised));
    Operations counted;
    bool inside = false;
    for (const codegen::Instruction& instruction : codegen::SpirvModule{optimised}.instructions) {
        inside = inside || instruction.op == spv::OpFunction;
        if (inside && !kMoves.contains(instruction.op)) {
            const bool extended = instruction.op == spv::OpExtInst;
            ++counted["op " + std::to_string(instruction.op) +
                      (extended ? " function " + std::to_string(instruction.operands[3]) : "")];
        }
        if (instruction.op == spv::OpFunctionEnd) inside = false;
    }
    return counted;
}

Words words_of(const ShaderFile& file) {
    Words words(file.contents.size() / sizeof(Words::value_type));
    std::memcpy(words.data(), file.contents.data(), file.contents.size());
    return words;
}

std::vector<ShaderFile> compute_kernels(const codegen::Package& package, Target target) {
    std::vector<ShaderFile> files;
    for (const ShaderFile& file : package.files)
        if (file.target == target && !file.entry_points.empty() &&
            file.entry_points[0].stage == "compute")
            files.push_back(file);
    return files;
}

const codegen::Package& constructs() {
    static const codegen::Package package = with_constructs();
    return package;
}

TEST(Meaning, OfGlslIsThatOfTheModule) {
    const SourceTree tree{SHADER_SOURCE};
    const auto originals = compute_kernels(constructs(), Target::spirv);
    const auto texts = compute_kernels(constructs(), Target::glsl450);
    ASSERT_EQ(originals.size(), texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const Words again = codegen::compile(tree, "again.comp", texts[i].contents, {});
        EXPECT_EQ(operations(again), operations(words_of(originals[i]))) << texts[i].path;
    }
}

TEST(Meaning, OfWgslIsThatOfWhatNagaWrote) {
    std::vector<codegen::NagaJob> jobs;
    for (const ShaderFile& file : compute_kernels(constructs(), Target::spirv))
        jobs.push_back({file.path.string(), words_of(file)});
    std::vector<std::string> texts = codegen::translate_to_wgsl(jobs);
    const std::size_t count = texts.size();
    for (const ShaderFile& file : compute_kernels(constructs(), Target::wgsl))
        texts.push_back(file.contents);
    const auto answers = codegen::translate_from_wgsl(texts);
    ASSERT_EQ(answers.size(), 2 * count);
    for (std::size_t i = 0; i < count; ++i)
        EXPECT_EQ(operations(answers[count + i].words), operations(answers[i].words))
            << jobs[i].name;
}

TEST(Meaning, ComparisonSeesAChangedOperation) {
    const SourceTree tree{SHADER_SOURCE};
    const ShaderFile eval = compute_kernels(everything(), Target::glsl450).at(2);
    std::string changed = eval.contents;
    const std::string what = "vec4(lq_plain_eval(surface, wi, wo)";
    ASSERT_NE(changed.find(what), std::string::npos) << eval.path;
    changed.replace(changed.find(what), what.size(), "vec4(2.0 * lq_plain_eval(surface, wi, wo)");
    EXPECT_NE(operations(codegen::compile(tree, "a.comp", changed, {})),
              operations(codegen::compile(tree, "b.comp", eval.contents, {})));
}

}  // namespace
}  // namespace lacquer::test
