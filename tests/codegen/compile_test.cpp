// Every generated file compiles, and the library form does so on its own under a new main.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cstring>

#include "check.h"
#include "codegen/compile.h"
#include "codegen/naga.h"
#include "core/file.h"
#include "core/process.h"
#include "support/temporary_folder.h"

namespace lacquer::test {
namespace {

using codegen::Form;
using codegen::ShaderFile;
using codegen::Target;

// A fragment shader of one's own around the functions.
std::string with_main(const ShaderFile& file) {
    constexpr std::string_view kPrecision = "precision highp float;\nprecision highp int;\n";
    constexpr std::string_view kMain = "void main() {\n}\n";
    switch (file.target) {
        case Target::glsl450:
            return fmt::format("#version 450\n{}{}", file.contents, kMain);
        case Target::essl310:
            return fmt::format("#version 310 es\n{}{}{}", kPrecision, file.contents, kMain);
        case Target::essl300:
            return fmt::format("#version 300 es\n{}{}{}", kPrecision, file.contents, kMain);
        default:
            return file.contents + std::string{kMain};
    }
}

TEST(Compile, EverySpirvModuleIsValid) {
    for (const ShaderFile& file : files_of(Target::spirv)) {
        codegen::Words words(file.contents.size() / sizeof(std::uint32_t));
        std::memcpy(words.data(), file.contents.data(), file.contents.size());
        EXPECT_NO_THROW(codegen::validate(words, file.path.string()));
    }
}

TEST(Compile, EveryGlslKernelCompiles) {
    for (const Target target : {Target::glsl450, Target::essl310, Target::essl300})
        for (const ShaderFile& file : files_of(target, Form::kernel))
            EXPECT_EQ(glsl_complaint(file.contents, file.entry_points.at(0).stage), "")
                << file.path;
}

TEST(Compile, EveryHlslKernelCompiles) {
    for (const Target target : {Target::hlsl50, Target::hlsl60})
        for (const ShaderFile& file : files_of(target, Form::kernel))
            EXPECT_EQ(hlsl_complaint(file.contents, file.entry_points.at(0).stage), "")
                << file.path;
}

TEST(Compile, GlslLibrariesCompileUnderANewMain) {
    for (const Target target : {Target::glsl450, Target::essl310, Target::essl300})
        for (const ShaderFile& file : files_of(target, Form::library))
            EXPECT_EQ(glsl_complaint(with_main(file), "fragment"), "") << file.path;
}

TEST(Compile, HlslLibrariesCompileUnderANewMain) {
    for (const Target target : {Target::hlsl50, Target::hlsl60})
        for (const ShaderFile& file : files_of(target, Form::library))
            EXPECT_EQ(hlsl_complaint(with_main(file), "fragment"), "") << file.path;
}

TEST(Compile, FrontEndsRefuseWhatIsNoShader) {
    const std::string wrong = "void main() { int x = y; }";
    EXPECT_NE(glsl_complaint("#version 450\n" + wrong, "fragment"), "");
    EXPECT_NE(hlsl_complaint(wrong, "fragment"), "");
}

TEST(Compile, EveryWgslFileIsValid) {
    const std::vector<ShaderFile> files = files_of(Target::wgsl);
    std::vector<std::string> texts;
    for (const ShaderFile& file : files) texts.push_back(file.contents);
    const std::vector<std::string> complaints = codegen::check_wgsl(texts);
    for (std::size_t i = 0; i < complaints.size(); ++i)
        EXPECT_EQ(complaints[i], "") << files[i].path;
}

TEST(Compile, NagaRefusesWhatIsNotWgsl) {
    const std::string wrong = "fn f() -> f32 { return 1u; }";
    EXPECT_THAT(codegen::check_wgsl({&wrong, 1}), testing::ElementsAre(testing::Not("")));
}

// Through the C++ shim of the backend msl: Apple's compiler runs nowhere else.
TEST(Compile, MslLibrariesCompileAsCpp) {
    const TemporaryFolder folder;
    for (const ShaderFile& file : files_of(Target::msl, Form::library)) {
        const std::filesystem::path source = folder.path() / "library.cpp";
        write_file(source, file.contents);
        const ProcessResult result = run_process(
            CXX_COMPILER, {"-std=c++20", "-fsyntax-only", "-D_MSC_EXTENSIONS", "-Wno-attributes",
                           "-fsingle-precision-constant", "-I", MSL_SHIM, source.string()});
        EXPECT_EQ(result.exit_code, 0) << file.path << "\n" << result.err;
    }
}

}  // namespace
}  // namespace lacquer::test
