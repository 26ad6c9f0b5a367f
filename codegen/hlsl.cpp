// HLSL through SPIRV-Cross.
#include <algorithm>
#include <spirv_cross/spirv_hlsl.hpp>

#include "codegen/emit.h"

namespace lacquer::codegen {

namespace {

using text::Statement;
using text::Statements;
using text::Token;
using text::Tokens;

constexpr const char* kInvocation = "gl_GlobalInvocationID";

// `0.0f.xxx` as `float3(0.0f, 0.0f, 0.0f)`.
void write_out_splats(Tokens& tokens) {
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        const bool splat = tokens[i].kind == text::TokenKind::number && tokens[i + 1].is(".") &&
                           tokens[i + 2].text.find_first_not_of('x') == std::string::npos;
        if (!splat) continue;
        const std::size_t width = tokens[i + 2].text.size();
        const std::string type = tokens[i].text.ends_with('f')   ? "float"
                                 : tokens[i].text.ends_with('u') ? "uint"
                                                                 : "int";
        std::string constructor = type + std::to_string(width) + "(";
        for (std::size_t k = 0; k < width; ++k)
            constructor += (k == 0 ? "" : ", ") + tokens[i].text;
        Tokens written = text::tokenize(constructor + ")");
        written.front().space = tokens[i].space;
        const auto at = tokens.begin() + static_cast<std::ptrdiff_t>(i);
        tokens.insert(tokens.erase(at, at + 3), written.begin(), written.end());
    }
}

Statement* find_function(Statements& statements, const std::string& name) {
    const auto found = std::ranges::find_if(statements, [&](const Statement& statement) {
        return definition_of(statement, text::Dialect::hlsl).name == name;
    });
    return found == statements.end() ? nullptr : &*found;
}

// SPIRV-Cross enters a compute shader through a struct, a global and a second function. Where
// nothing else reads the global, its value becomes the parameter of a single function.
void join_entry_point(Statements& statements) {
    const Statement* inner = find_function(statements, "comp_main");
    Statement* outer = find_function(statements, "main");
    if (inner == nullptr || outer == nullptr) return;
    const auto is_global = [](const Statement& statement) {
        return statement.starts_with("static") && statement.head.back().is(kInvocation);
    };
    const auto is_input = [](const Statement& statement) {
        return statement.starts_with("struct") && statement.head[1].is("SPIRV_Cross_Input") &&
               statement.body.size() == 1 && statement.body[0].head[1].is(kInvocation);
    };
    const auto others = std::ranges::count_if(statements, [&](const Statement& statement) {
        const bool known = &statement == inner || &statement == outer || is_global(statement) ||
                           is_input(statement);
        return !known && count_mentions(statement, kInvocation) > 0;
    });
    if (others > 0 || std::ranges::none_of(statements, is_input)) return;
    outer->body = inner->body;
    const std::size_t parameters = outer->head.size() - 3;  // SPIRV_Cross_Input stage_input )
    outer->head.resize(parameters);
    const Tokens parameter = text::tokenize("uint3 gl_GlobalInvocationID : SV_DispatchThreadID)");
    outer->head.insert(outer->head.end(), parameter.begin(), parameter.end());
    std::erase_if(statements, [&](const Statement& statement) {
        return is_global(statement) || is_input(statement) ||
               definition_of(statement, text::Dialect::hlsl).name == "comp_main";
    });
}

// Puts `[numthreads(64, 1, 1)]` on its own line.
void separate_attributes(Statements& statements) {
    for (Statement& statement : statements) {
        if (!statement.starts_with("[")) continue;
        const auto end = static_cast<std::ptrdiff_t>(closing(statement.head, 0)) + 1;
        statement.above.push_back(
            text::join({statement.head.begin(), statement.head.begin() + end}));
        statement.head.erase(statement.head.begin(), statement.head.begin() + end);
    }
}

}  // namespace

Statements emit_hlsl(const Words& words, Target target) {
    spirv_cross::CompilerHLSL compiler{words};
    spirv_cross::CompilerHLSL::Options options;
    options.shader_model = target == Target::hlsl50 ? 50 : 60;
    compiler.set_hlsl_options(options);
    spirv_cross::CompilerGLSL::Options common = compiler.get_common_options();
    common.vertex.flip_vert_y = true;  // the source is Vulkan's, whose y points down
    compiler.set_common_options(common);
    Statements statements = text::parse(compiler.compile(), text::Dialect::hlsl);
    for_each_tokens(statements, write_out_splats);
    join_entry_point(statements);
    tidy_c_family(statements, text::Dialect::hlsl);
    separate_attributes(statements);
    return statements;
}

}  // namespace lacquer::codegen
