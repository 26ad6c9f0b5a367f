#include "check.h"

#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>

#include <sstream>

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
        return codegen::generate(request);
    }();
    return package;
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

std::string without_comments(const std::string& text) {
    std::istringstream lines{text};
    std::string code;
    for (std::string line; std::getline(lines, line);)
        code += line.substr(0, line.find("//")) + "\n";
    return code;
}

}  // namespace lacquer::test
