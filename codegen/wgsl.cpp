// WGSL from naga's text.
#include <algorithm>
#include <regex>

#include "codegen/emit.h"
#include "codegen/text/expressions.h"
#include "codegen/text/locals.h"
#include "codegen/text/wgsl.h"

namespace lacquer::codegen {

namespace {

using text::Dialect;
using text::Statement;
using text::Statements;
using text::Tokens;

// `vec3<f32>` as `vec3f`, and the like.
std::string with_short_types(const std::string& text) {
    static const std::regex kVector{R"(\b(vec[234]|mat[234]x[234])<([fiu])(?:32)>)"};
    return std::regex_replace(text, kVector, "$1$2");
}

bool is_function(const Statement& statement) {
    return definition_of(statement, Dialect::wgsl).kind == text::DefinitionKind::function;
}

// Names of `var`s outside functions.
text::ModuleVariables module_variables(const Statements& statements) {
    text::ModuleVariables names;
    for (const Statement& statement : statements)
        if (!statement.has_block && text::mentions(statement.head, "var"))
            for (std::size_t i = 0; i + 1 < statement.head.size(); ++i)
                if (statement.head[i + 1].is(":")) names.insert(statement.head[i].text);
    return names;
}

// Moves attributes of a function to a line of their own.
void separate_attributes(Statement& function) {
    const auto keyword = std::ranges::find(function.head, "fn", &text::Token::text);
    if (keyword == function.head.begin()) return;
    function.above.push_back(text::join({function.head.begin(), keyword}));
    function.head.erase(function.head.begin(), keyword);
}

void drop_final_return(Statement& function) {
    if (function.body.empty()) return;
    const Statement& last = function.body.back();
    if (last.head.size() == 1 && last.starts_with("return")) function.body.pop_back();
}

// `let x = y;` where y is a parameter that goes by a worse name now.
void drop_copies_of_parameters(Statement& function) {
    Statements& body = function.body;
    for (std::size_t i = 0; i < body.size();) {
        const Tokens& head = body[i].head;
        const bool copy = body[i].starts_with("let") && head.size() == 4 && !body[i].has_block &&
                          head[3].kind == text::TokenKind::identifier &&
                          text::mentions(function.head, head[3].text);
        if (!copy) {
            ++i;
            continue;
        }
        const std::string name = head[1].text;
        const std::string parameter = head[3].text;
        body.erase(body.begin() + static_cast<std::ptrdiff_t>(i));
        rename(body, name, parameter);
    }
}

// The block of built-in outputs has no name in the source.
constexpr const char* kUnnamed = "unnamed";
constexpr const char* kBuiltInOutputs = "per_vertex";

}  // namespace

Statements emit_wgsl(const std::string& naga_text) {
    Statements statements = text::parse(with_short_types(naga_text), Dialect::wgsl);
    rename(statements, kUnnamed, kBuiltInOutputs);
    text::join_entry_point(statements);
    const text::ModuleVariables variables = module_variables(statements);
    const text::Types module_types = text::module_types(statements);
    for (Statement& statement : statements) {
        if (!is_function(statement)) continue;
        const text::Types types = text::function_types(statement, module_types);
        text::restore_swizzles(statement, types);
        text::join_vectors(statement, types);
        text::inline_lets(statement, variables);
        for_each_tokens(statement.body, text::remove_parentheses);
        text::restore_swizzles(statement, types);
        text::merge_choices(statement);
        text::place_variables(statement);
        drop_copies_of_parameters(statement);
        text::parenthesize_conditions(statement);
        drop_final_return(statement);
    }
    name_tables(statements, Dialect::wgsl);
    std::vector<std::string> names;
    for (const Statement& statement : statements)
        names.push_back(definition_of(statement, Dialect::wgsl).name);
    names.insert(names.end(), variables.begin(), variables.end());
    for_each_tokens(statements, text::restore_literals);
    for_each_tokens(statements, text::join_splats);
    for_each_tokens(statements, text::join_components);
    for_each_tokens(statements, text::remove_parentheses);
    for (Statement& statement : statements) {
        if (!is_function(statement)) continue;
        text::restore_compound_assignments(statement);
        text::restore_loops(statement);
        for_each_tokens(statement.body, text::remove_parentheses);
        text::drop_copies(statement, Dialect::wgsl);
        text::name_locals(statement, Dialect::wgsl);
        text::name_built_ins(statement, Dialect::wgsl);
        text::restore_names(statement, Dialect::wgsl, names);
        separate_attributes(statement);
    }
    text::join_else_if(statements);
    return statements;
}

}  // namespace lacquer::codegen
