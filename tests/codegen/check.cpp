#include "check.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <sstream>

#include "codegen/emit.h"
#include "codegen/naga.h"
#include "codegen/variants.h"
#include "core/file.h"
#include "core/process.h"
#include "support/temporary_folder.h"

namespace lacquer::test {

namespace {

constexpr int kDefaultVersion = 450;

EShLanguage language_of(std::string_view stage) {
    if (stage == "vertex") return EShLangVertex;
    return stage == "fragment" ? EShLangFragment : EShLangCompute;
}

std::string complaint(const std::string& text, std::string_view stage, bool hlsl) {
    static const bool started = glslang::InitializeProcess();
    if (!started) return "glslang did not start";
    const EShLanguage language = language_of(stage);
    glslang::TShader shader{language};
    const char* strings[] = {text.c_str()};
    shader.setStrings(strings, 1);
    auto messages = EShMsgDefault;
    if (hlsl) {
        messages = static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules);
        shader.setEntryPoint("main");
        shader.setEnvInput(glslang::EShSourceHlsl, language, glslang::EShClientVulkan, 110);
        shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
        shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    }
    if (!shader.parse(GetDefaultResources(), kDefaultVersion, false, messages))
        return shader.getInfoLog();
    glslang::TProgram program;
    program.addShader(&shader);
    return program.link(messages) ? std::string{} : program.getInfoLog();
}

}  // namespace

const codegen::Package& everything() {
    static const codegen::Package package = [] {
        codegen::Request request;
        request.source_root = SHADER_SOURCE;
        request.tables_folder = BAKED_TABLES;
        return codegen::generate(request);
    }();
    return package;
}

codegen::Package with_constructs() {
    const TemporaryFolder folder;
    const std::filesystem::path root = folder / "source";
    std::filesystem::copy(SHADER_SOURCE, root, std::filesystem::copy_options::recursive);
    const std::filesystem::path tests = TEST_SOURCE;
    std::filesystem::copy_file(tests / "constructs.comp", root / "kernels" / "constructs.comp");
    std::filesystem::copy_file(tests / "constructs.glsl", root / "plain" / "constructs.glsl");
    // The level includes them, so that its library has them too.
    const std::filesystem::path level = root / "plain" / "plain.glsl";
    const std::string include = "#include \"../one_coat/lobes.glsl\"\n";
    std::string text = read_file(level);
    text.insert(text.find(include), "#include \"constructs.glsl\"\n");
    write_file(level, text);
    codegen::Request request;
    request.source_root = root;
    request.levels = {"plain"};
    return codegen::generate(request);
}

std::vector<codegen::ShaderFile> files_of(codegen::Target target) {
    std::vector<codegen::ShaderFile> files;
    for (const codegen::ShaderFile& file : everything().files)
        if (file.target == target) files.push_back(file);
    return files;
}

std::vector<codegen::ShaderFile> files_of(codegen::Target target, codegen::Form form) {
    std::vector<codegen::ShaderFile> files = files_of(target);
    std::erase_if(files, [&](const codegen::ShaderFile& file) { return file.form != form; });
    return files;
}

std::vector<codegen::Target> text_targets() {
    std::vector<codegen::Target> targets;
    for (const codegen::Target target : codegen::all_targets())
        if (target != codegen::Target::spirv) targets.push_back(target);
    return targets;
}

std::string glsl_complaint(const std::string& text, std::string_view stage) {
    return complaint(text, stage, false);
}

std::string hlsl_complaint(const std::string& text, std::string_view stage) {
    return complaint(text, stage, true);
}

// What users of a library supply.
std::string stand_ins(const codegen::ShaderFile& file) {
    const codegen::Level& level = codegen::level_from_name(file.level);
    if (file.form != codegen::Form::library || !level.reads_tables) return {};
    std::string tables, layers;
    switch (codegen::dialect_of(file.target)) {
        case codegen::text::Dialect::hlsl:
            tables = "uint4 lq_table_texel(int index) { return uint4(index, 0, 0, 0); }\n";
            layers = "float4 lq_stack_row(int index) { return float4(index, 0, 0, 0); }\n";
            break;
        case codegen::text::Dialect::wgsl:
            tables =
                "fn lq_table_texel(index: i32) -> vec4<u32> { return vec4<u32>(u32(index)); }\n";
            layers = "fn lq_stack_row(index: i32) -> vec4<f32> { return vec4<f32>(f32(index)); }\n";
            break;
        case codegen::text::Dialect::msl:
            tables =
                "#include <metal_stdlib>\nusing namespace metal;\n"
                "static inline uint4 lq_table_texel(int index) { return uint4(index); }\n";
            layers = "static inline float4 lq_stack_row(int index) { return float4(index); }\n";
            break;
        default:
            tables = "uvec4 lq_table_texel(int index) { return uvec4(uint(index)); }\n";
            layers = "vec4 lq_stack_row(int index) { return vec4(float(index)); }\n";
    }
    return tables + (level.reads_layers ? layers : std::string{});
}

std::string as_shader(const codegen::ShaderFile& file) {
    if (file.form == codegen::Form::kernel) return file.contents;
    const std::string contents = stand_ins(file) + file.contents;
    constexpr std::string_view kPrecision = "precision highp float;\nprecision highp int;\n";
    const std::string main = "void main() {\n}\n";
    switch (file.target) {
        case codegen::Target::glsl450:
            return fmt::format("#version 450\n{}{}", contents, main);
        case codegen::Target::essl310:
            return fmt::format("#version 310 es\n{}{}{}", kPrecision, contents, main);
        case codegen::Target::essl300:
            return fmt::format("#version 300 es\n{}{}{}", kPrecision, contents, main);
        case codegen::Target::wgsl:
            return contents;
        default:
            return contents + main;
    }
}

namespace {

// What the C++ compiler says against Metal, through the shim of the backend msl: Apple's compiler
// runs nowhere else.
std::string msl_complaint(const codegen::ShaderFile& file) {
    const TemporaryFolder folder;
    const std::filesystem::path source = folder / "shader.cpp";
    write_file(source, stand_ins(file) + file.contents);
    const ProcessResult result = run_process(
        CXX_COMPILER, {"-std=c++20", "-fsyntax-only", "-D_MSC_EXTENSIONS", "-Wno-attributes",
                       "-fsingle-precision-constant", "-I", MSL_SHIM, source.string()});
    return result.exit_code == 0 ? std::string{} : result.err;
}

}  // namespace

std::string complaint(const codegen::ShaderFile& file) {
    const std::string text = as_shader(file);
    const std::string stage = file.entry_points.empty() ? "fragment" : file.entry_points[0].stage;
    switch (codegen::dialect_of(file.target)) {
        case codegen::text::Dialect::hlsl:
            return hlsl_complaint(text, stage);
        case codegen::text::Dialect::glsl:
            return glsl_complaint(text, stage);
        case codegen::text::Dialect::wgsl:
            return codegen::translate_from_wgsl({&text, 1}).at(0).complaint;
        case codegen::text::Dialect::msl:
            return msl_complaint(file);
    }
    return "no compiler";
}

std::string without_comments(const std::string& text) {
    std::istringstream lines{text};
    std::string code;
    for (std::string line; std::getline(lines, line);)
        code += line.substr(0, line.find("//")) + "\n";
    return code;
}

}  // namespace lacquer::test
