#include "backends/hlsl_to_spirv.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include "core/error.h"

namespace lacquer {

namespace {

constexpr int kShaderModel = 500;
constexpr auto kRules =
    static_cast<EShMessages>(EShMsgReadHlsl | EShMsgSpvRules | EShMsgVulkanRules);

// glslang wants to be set up once per process.
void start_glslang() {
    static const bool started = glslang::InitializeProcess();
    if (!started) throw Error{"glslang did not start"};
}

}  // namespace

std::vector<std::uint32_t> hlsl_to_spirv(const std::string& source, const std::string& entry_point,
                                         const std::string& file) {
    start_glslang();
    glslang::TShader shader{EShLangCompute};
    const char* strings[] = {source.c_str()};
    const char* names[] = {file.c_str()};
    shader.setStringsWithLengthsAndNames(strings, nullptr, names, 1);
    shader.setEntryPoint(entry_point.c_str());
    shader.setEnvInput(glslang::EShSourceHlsl, EShLangCompute, glslang::EShClientVulkan,
                       kShaderModel);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    if (!shader.parse(GetDefaultResources(), kShaderModel, false, kRules))
        throw Error{fmt::format("glslang: {}", shader.getInfoLog())};

    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(kRules))
        throw Error{fmt::format("glslang: {}: {}", file, program.getInfoLog())};
    std::vector<std::uint32_t> words;
    glslang::SpvOptions options;
    options.disableOptimizer = true;
    glslang::GlslangToSpv(*program.getIntermediate(EShLangCompute), words, &options);
    return words;
}

}  // namespace lacquer
