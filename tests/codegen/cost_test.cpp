// What shaders cost: counts of instructions and of texels.
#include "codegen/cost.h"

#include <gmock/gmock.h>

#include "check.h"
#include "shading/shader_double.h"

namespace lacquer::test {
namespace {

using codegen::ShaderFile;
using codegen::Words;

const ShaderFile& find_file(const std::string& path) {
    for (const ShaderFile& file : everything().files)
        if (file.path == path) return file;
    throw std::runtime_error{"no file " + path};
}

std::size_t function_cost(const std::string& path, const std::string& name) {
    for (const codegen::Function& function : find_file(path).functions)
        if (function.name == name) return function.instruction_count.value_or(0);
    throw std::runtime_error{"no function " + name};
}

Words compiled(const std::string& text) {
    const codegen::SourceTree tree{SHADER_SOURCE};
    return codegen::compile(tree, "cost.comp", "#version 450\n" + text,
                            {codegen::Stage::compute, {}, false});
}

// One load, one sum, one store, their addresses, and what opens and closes a function.
TEST(Cost, OfAnEntryPointIsThatOfItsInstructionsAfterOptimisation) {
    const Words words = compiled(
        "layout(set = 0, binding = 0, std430) buffer B { float x; } b;\n"
        "float twice(float x) { float unused = x * 3.0; return x + x; }\n"
        "void main() { b.x = twice(b.x); }\n");
    // OpFunction, OpLabel, OpAccessChain, OpLoad, OpFAdd, OpStore, OpReturn, OpFunctionEnd; and
    // perhaps the second OpAccessChain.
    EXPECT_THAT(codegen::optimised_instruction_count(words, "main"),
                testing::AllOf(testing::Ge(8u), testing::Le(9u)));
}

TEST(Cost, OfAFunctionIncludesWhatItCalls) {
    const auto path = "spirv/kernel/plain_eval.spv";
    EXPECT_GT(find_file(path).entry_points[0].instruction_count,
              function_cost("glsl450/library/plain.glsl", "lq_plain_eval"));
    for (const char* level : {"plain", "coated"}) {
        const auto cost = [&](const std::string& verb) {
            return function_cost(std::string{"glsl450/library/"} + level + ".glsl",
                                 std::string{"lq_"} + level + "_" + verb);
        };
        EXPECT_GT(cost("prepare"), 0u);
        EXPECT_GT(cost("eval_cos"), cost("eval"));
        EXPECT_GT(cost("sample"), cost("eval_cos"));
    }
}

TEST(Cost, IsThatOfTheModuleInEveryLanguage) {
    const ShaderFile& spirv = find_file("spirv/kernel/plain_eval.spv");
    const ShaderFile& wgsl = find_file("wgsl/kernel/plain_eval.wgsl");
    EXPECT_EQ(spirv.instruction_count, wgsl.instruction_count);
    EXPECT_EQ(spirv.entry_points[0].instruction_count, wgsl.entry_points[0].instruction_count);
    EXPECT_LT(find_file("spirv/kernel/plain_copy.spv").entry_points[0].instruction_count, 40u);
}

// Four nodes about a point of (alpha, eta), two along tau for each channel; the first node of a
// clear medium; two nodes each of the lobe's roughness and energy.
TEST(Cost, TexelsReadAreThoseThatTheLayoutNeeds) {
    using namespace shader;
    constexpr std::size_t kRUp = 1, kMultiple = 1;  // texels per node
    const std::size_t below_one = 4 * (2 * LQ_T_DOWN_TEXELS + kRUp + 2 * kMultiple);
    const std::size_t tau = 2 * 3 * LQ_ABSORPTION_TEXELS + 1;
    const ShaderFile& library = find_file("glsl450/library/coated.glsl");
    EXPECT_EQ(library.table_reads, below_one + tau + 2 * 2);
    EXPECT_EQ(find_file("spirv/kernel/coated_eval.spv").table_reads, library.table_reads);
    EXPECT_EQ(find_file("glsl450/library/plain.glsl").table_reads, 0u);
    EXPECT_EQ(find_file("essl300/kernel/coated_sphere_view.vert.glsl").table_reads, 0u);
}

}  // namespace
}  // namespace lacquer::test
