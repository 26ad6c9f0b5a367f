// Metal Shading Language through SPIRV-Cross.
#include <spirv_cross/spirv_msl.hpp>

#include "codegen/emit.h"

namespace lacquer::codegen {

namespace {

using text::Statement;
using text::Statements;
using text::Tokens;

// `fast::clamp` as `clamp`: which of the two precisions it has is the compiler option's to say.
void drop_fast(Tokens& tokens) {
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (!tokens[i].is("fast") || !tokens[i + 1].is("::")) continue;
        tokens[i + 2].space = tokens[i].space;
        const auto at = tokens.begin() + static_cast<std::ptrdiff_t>(i);
        tokens.erase(at, at + 2);
    }
}

// `((device float*)&rows[i])[2u]` as `rows[i].z`.
void restore_components(Tokens& tokens) {
    for (std::size_t i = 0; i + 8 < tokens.size(); ++i) {
        const bool pointer = tokens[i].is("(") && tokens[i + 1].is("(");
        if (!pointer) continue;
        const std::size_t cast_end = closing(tokens, i + 1);
        const std::size_t end = closing(tokens, i);
        const bool indexed = cast_end + 1 < end && tokens[cast_end - 1].is("*") &&
                             tokens[cast_end + 1].is("&") && end + 3 < tokens.size() &&
                             tokens[end + 1].is("[") && tokens[end + 2].text.size() == 2;
        if (!indexed) continue;
        const char component = "xyzw"[(tokens[end + 2].text[0] - '0') & 3];
        Tokens chain{tokens.begin() + static_cast<std::ptrdiff_t>(cast_end) + 2,
                     tokens.begin() + static_cast<std::ptrdiff_t>(end)};
        chain.front().space = tokens[i].space;
        chain.push_back({.text = "."});
        chain.push_back({.kind = text::TokenKind::identifier, .text = std::string(1, component)});
        const auto first = tokens.begin() + static_cast<std::ptrdiff_t>(i);
        const auto rest =
            tokens.erase(first, tokens.begin() + static_cast<std::ptrdiff_t>(end) + 4);
        tokens.insert(rest, chain.begin(), chain.end());
    }
}

// `static inline __attribute__((always_inline))` as `static inline`.
void drop_attribute(Statement& statement) {
    Tokens& head = statement.head;
    for (std::size_t i = 0; i + 1 < head.size(); ++i) {
        if (!head[i].is("__attribute__")) continue;
        const auto first = head.begin() + static_cast<std::ptrdiff_t>(i);
        head.erase(first, head.begin() + static_cast<std::ptrdiff_t>(closing(head, i + 1)) + 1);
        return;
    }
}

// Functions are static here, and nothing of simd's own is used.
bool is_needless(const Statement& statement) {
    return statement.is_line() && (statement.head[0].text.starts_with("#pragma clang") ||
                                   statement.head[0].is("#include <simd/simd.h>"));
}

// SPIRV-Cross says this behind the line that does it.
bool is_remark_on_y(const Statement& statement) {
    return statement.is_line() && statement.head[0].text.starts_with("// Invert Y-axis");
}

}  // namespace

Statements emit_msl(const Words& words) {
    spirv_cross::CompilerMSL compiler{words};
    spirv_cross::CompilerMSL::Options options;
    options.set_msl_version(2, 2);
    options.enable_decoration_binding = true;
    options.force_native_arrays = true;
    compiler.set_msl_options(options);
    spirv_cross::CompilerGLSL::Options common = compiler.get_common_options();
    common.vertex.flip_vert_y = true;  // the source is Vulkan's, whose y points down
    compiler.set_common_options(common);
    Statements statements = text::parse(compiler.compile(), text::Dialect::msl);
    for_each_tokens(statements, drop_fast);
    for_each_tokens(statements, restore_components);
    for (Statement& statement : statements) {
        drop_attribute(statement);
        std::erase_if(statement.body, is_remark_on_y);
    }
    std::erase_if(statements, is_needless);
    tidy_c_family(statements, text::Dialect::msl);
    return statements;
}

}  // namespace lacquer::codegen
