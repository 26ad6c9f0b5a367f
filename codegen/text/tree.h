// A shader as nested statements: enough structure to tidy it, for every language alike.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "codegen/text/token.h"

namespace lacquer::codegen::text {

enum class Dialect { glsl, hlsl, msl, wgsl };

struct Statement {
    std::vector<std::string> above{};  // lines printed above it: its documentation, attributes
    bool gap = false;                  // a blank line stands above those
    Tokens head{};                     // all before the block or the end
    bool has_block = false;
    std::vector<Statement> body{};
    Tokens tail{};      // between the block and the end: the name of an interface block
    std::string end{};  // ";", "," or nothing

    bool starts_with(std::string_view word) const { return !head.empty() && head[0].is(word); }
    bool is_line() const { return !head.empty() && head[0].kind == TokenKind::line; }
};

using Statements = std::vector<Statement>;

// What a statement at the top of a file defines.
enum class DefinitionKind { none, constant, structure, function, variable };

struct Definition {
    DefinitionKind kind = DefinitionKind::none;
    std::string name;
};

Statements parse(std::string_view source, Dialect dialect);

Definition definition_of(const Statement& statement, Dialect dialect);

// Calls `visit` for `statements` and every list of statements within, innermost first.
void for_each_list(Statements& statements, const std::function<void(Statements&)>& visit);

// Calls `visit` with the tokens of every statement, heads and tails.
void for_each_tokens(Statements& statements, const std::function<void(Tokens&)>& visit);
void for_each_tokens(const Statements& statements, const std::function<void(const Tokens&)>& visit);

// How often `name` occurs as a free name in `statement` and all within.
std::size_t count_mentions(const Statement& statement, std::string_view name);

// Replaces the free name `from` by `to` throughout.
void rename(Statements& statements, std::string_view from, const std::string& to);
void rename(Statement& statement, std::string_view from, const std::string& to);

}  // namespace lacquer::codegen::text
