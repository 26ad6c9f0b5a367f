// Every generated file compiles, and the library form does so on its own under a new main.
#include <gmock/gmock.h>

#include <cstring>

#include "check.h"
#include "codegen/compile.h"
#include "codegen/naga.h"

namespace lacquer::test {
namespace {

using codegen::Form;
using codegen::ShaderFile;
using codegen::Target;

TEST(Compile, EverySpirvModuleIsValid) {
    for (const ShaderFile& file : files_of(Target::spirv)) {
        codegen::Words words(file.contents.size() / sizeof(std::uint32_t));
        std::memcpy(words.data(), file.contents.data(), file.contents.size());
        EXPECT_NO_THROW(codegen::validate(words, file.path.string()));
    }
}

TEST(Compile, EveryGlslFileCompiles) {
    for (const Target target : {Target::glsl450, Target::essl310, Target::essl300})
        for (const ShaderFile& file : files_of(target)) EXPECT_EQ(complaint(file), "") << file.path;
}

TEST(Compile, EveryHlslFileCompiles) {
    for (const Target target : {Target::hlsl50, Target::hlsl60})
        for (const ShaderFile& file : files_of(target)) EXPECT_EQ(complaint(file), "") << file.path;
}

TEST(Compile, FrontEndsRefuseWhatIsNoShader) {
    const std::string wrong = "void main() { int x = y; }";
    EXPECT_NE(glsl_complaint("#version 450\n" + wrong, "fragment"), "");
    EXPECT_NE(hlsl_complaint(wrong, "fragment"), "");
}

TEST(Compile, EveryWgslFileIsValid) {
    const std::vector<ShaderFile> files = files_of(Target::wgsl);
    std::vector<std::string> texts;
    for (const ShaderFile& file : files) texts.push_back(as_shader(file));
    const std::vector<codegen::NagaAnswer> answers = codegen::translate_from_wgsl(texts);
    for (std::size_t i = 0; i < answers.size(); ++i)
        EXPECT_EQ(answers[i].complaint, "") << files[i].path;
}

TEST(Compile, NagaRefusesWhatIsNotWgsl) {
    const std::string wrong = "fn f() -> f32 { return 1u; }";
    EXPECT_NE(codegen::translate_from_wgsl({&wrong, 1}).at(0).complaint, "");
}

TEST(Compile, MslLibrariesCompileAsCpp) {
    for (const ShaderFile& file : files_of(Target::msl, Form::library))
        EXPECT_EQ(complaint(file), "") << file.path;
}

// Shader source of later levels: arrays of structs, nested loops, tables, bits, choices.
TEST(Compile, ConstructsCompileInEveryLanguage) {
    for (const ShaderFile& file : with_constructs().files) {
        const bool library = file.form == Form::library;
        if (file.target == Target::spirv || (!library && file.kernel != "constructs")) continue;
        EXPECT_EQ(complaint(file), "") << file.path << "\n" << file.contents;
    }
}

}  // namespace
}  // namespace lacquer::test
