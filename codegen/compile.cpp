#include "codegen/compile.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>

#include <deque>
#include <memory>
#include <regex>
#include <set>
#include <spirv-tools/libspirv.hpp>
#include <spirv-tools/optimizer.hpp>

#include "core/error.h"

namespace lacquer::codegen {

namespace {

constexpr int kGlslVersion = 450;

// glslang wants to be set up once per process.
void start_glslang() {
    static const bool started = glslang::InitializeProcess();
    if (!started) throw Error{"glslang did not start"};
}

EShLanguage glslang_stage(Stage stage) {
    switch (stage) {
        case Stage::compute:
            return EShLangCompute;
        case Stage::vertex:
            return EShLangVertex;
        case Stage::fragment:
            return EShLangFragment;
    }
    return EShLangCompute;
}

// Names that stand between square brackets somewhere: naga takes no specialization constant there.
std::set<std::string> array_sizes(const SourceTree& tree) {
    static const std::regex kSize{R"(\[\s*(LQ_\w+)\s*\])"};
    std::set<std::string> names;
    for (const auto& [name, text] : tree.files())
        for (std::sregex_iterator match{text.begin(), text.end(), kSize}, end; match != end;
             ++match)
            names.insert((*match)[1]);
    return names;
}

// Gives texts to glslang, with constants marked as specialization constants where asked for.
class Includer : public glslang::TShader::Includer {
 public:
    Includer(const SourceTree& tree, bool named_constants)
        : tree_{tree}, named_constants_{named_constants} {
        if (named_constants) array_sizes_ = array_sizes(tree);
    }

    IncludeResult* includeLocal(const char* header, const char* including, std::size_t) override {
        const std::string name = SourceTree::resolve(unshown(including), header);
        const std::string* text = tree_.find(name);
        if (text == nullptr) return nullptr;
        const std::string& kept = texts_.emplace_back(prepared(*text));
        return new IncludeResult{tree_.shown(name), kept.data(), kept.size(), nullptr};
    }

    void releaseInclude(IncludeResult* result) override { delete result; }

    // `text` as glslang is to see it; no line is added or removed.
    std::string prepared(const std::string& text) {
        if (!named_constants_) return text;
        static const std::regex kConstant{R"(^const (?:float|int|uint) (LQ_\w+) = -?[0-9.]\S*;)",
                                          std::regex::multiline};
        std::string marked;
        auto from = text.cbegin();
        for (std::sregex_iterator match{text.begin(), text.end(), kConstant}, end; match != end;
             ++match) {
            const auto at = text.cbegin() + match->position();
            marked.append(from, at);
            from = at;
            if (!array_sizes_.contains((*match)[1]))
                marked += fmt::format("layout(constant_id = {}) ", next_id_++);
        }
        return marked.append(from, text.cend());
    }

 private:
    // The name in the tree of a file shown as `path`.
    std::string unshown(const std::string& path) const {
        const std::string root = tree_.shown("");
        return path.starts_with(root) ? path.substr(root.size()) : path;
    }

    const SourceTree& tree_;
    bool named_constants_;
    std::set<std::string> array_sizes_;
    std::deque<std::string> texts_;
    int next_id_ = 0;
};

// "ERROR: FILE:LINE: ..." as "FILE:LINE: ...", without glslang's closing summary.
std::string tidy_messages(const std::string& log) {
    static const std::regex kPrefix{R"(^ERROR: )", std::regex::multiline};
    static const std::regex kSummary{R"((?:^\d+ compilation errors?\..*$)|(?:\n\s*)+$)",
                                     std::regex::multiline};
    return std::regex_replace(std::regex_replace(log, kPrefix, ""), kSummary, "");
}

Words to_spirv(const SourceTree& tree, const std::string& file, const std::string& text,
               const CompileOptions& options) {
    start_glslang();
    Includer includer{tree, options.named_constants};
    const EShLanguage stage = glslang_stage(options.stage);
    glslang::TShader shader{stage};
    const std::string source = includer.prepared(text);
    const std::string name = tree.shown(file);
    const char* strings[] = {source.c_str()};
    const int lengths[] = {static_cast<int>(source.size())};
    const char* names[] = {name.c_str()};
    shader.setStringsWithLengthsAndNames(strings, lengths, names, 1);
    shader.setPreamble(options.preamble.c_str());
    shader.setEnvInput(glslang::EShSourceGlsl, stage, glslang::EShClientVulkan, kGlslVersion);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_1);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_3);
    const auto rules = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    if (!shader.parse(GetDefaultResources(), kGlslVersion, false, rules, includer))
        throw Error{tidy_messages(shader.getInfoLog())};
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(rules))
        throw Error{fmt::format("{}: {}", name, tidy_messages(program.getInfoLog()))};
    Words words;
    glslang::SpvOptions spirv_options;
    spirv_options.disableOptimizer = true;
    glslang::GlslangToSpv(*program.getIntermediate(stage), words, &spirv_options);
    return words;
}

}  // namespace

Words compile(const SourceTree& tree, const std::string& file, const std::string& text,
              const CompileOptions& options) {
    const Words raw = to_spirv(tree, file, text, options);
    spvtools::Optimizer optimizer{SPV_ENV_VULKAN_1_1};
    std::string message;
    optimizer.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&,
                                     const char* said) { message = said; });
    // These keep variables and their names; passes that rewrite to SSA form or inline do not, and
    // merging blocks moves the bodies of loops to where no language can write a plain `for`.
    optimizer.RegisterPass(spvtools::CreateDeadBranchElimPass())
        .RegisterPass(spvtools::CreateEliminateDeadConstantPass())
        .RegisterPass(spvtools::CreateEliminateDeadFunctionsPass());
    Words words;
    if (!optimizer.Run(raw.data(), raw.size(), &words))
        throw Error{fmt::format("{}: SPIRV-Tools: {}", tree.shown(file), message)};
    return words;
}

void validate(const Words& words, const std::string& file) {
    spvtools::SpirvTools tools{SPV_ENV_VULKAN_1_1};
    std::string message;
    tools.SetMessageConsumer([&](spv_message_level_t, const char*, const spv_position_t&,
                                 const char* said) { message = said; });
    if (!tools.Validate(words)) throw Error{fmt::format("{}: invalid SPIR-V: {}", file, message)};
}

}  // namespace lacquer::codegen
