#include "codegen/text/tree.h"

#include <algorithm>
#include <array>

namespace lacquer::codegen::text {

namespace {

template <std::size_t N>
bool is_one_of(const Token& token, const std::array<std::string_view, N>& words) {
    return std::ranges::any_of(words, [&](std::string_view word) { return token.is(word); });
}

constexpr std::array<std::string_view, 8> kControl{"if",   "else", "for",        "while",
                                                   "loop", "do",   "continuing", "switch"};
constexpr std::array<std::string_view, 6> kRecords{"struct", "cbuffer", "layout",
                                                   "buffer", "uniform", "tbuffer"};

class Parser {
 public:
    Parser(const Tokens& tokens, Dialect dialect) : tokens_{tokens}, dialect_{dialect} {}

    // Statements up to the end of the block, or of the file.
    Statements block(bool top_level, bool members) {
        Statements statements;
        while (at_ < tokens_.size() && !tokens_[at_].is("}"))
            statements.push_back(statement(top_level, members));
        return statements;
    }

 private:
    Statement statement(bool top_level, bool members) {
        Statement result;
        int depth = 0;
        while (at_ < tokens_.size()) {
            const Token& token = tokens_[at_];
            if (token.kind == TokenKind::line && result.head.empty()) {
                ++at_;
                result.head = {token};
                return result;
            }
            if (depth == 0 && token.is("}")) return result;
            if (depth == 0 && ends_here(result, token, members)) {
                ++at_;
                result.end = token.text;
                return result;
            }
            if (depth == 0 && token.is("{") && opens_block(result, top_level)) {
                with_block(result, top_level);
                return result;
            }
            const bool generic = members && (token.is("<") || token.is(">"));
            if (token.is("(") || token.is("[") || token.is("{")) ++depth;
            if (token.is(")") || token.is("]") || token.is("}")) --depth;
            if (generic) depth += token.is("<") ? 1 : -1;
            result.head.push_back(token);
            ++at_;
        }
        return result;
    }

    static bool ends_here(const Statement& statement, const Token& token, bool members) {
        if (token.is(";") || (members && token.is(","))) return true;
        return token.is(":") && (statement.starts_with("case") || statement.starts_with("default"));
    }

    static bool opens_block(const Statement& statement, bool top_level) {
        if (statement.head.empty()) return true;
        if (top_level) return !assigns(statement.head);
        return is_one_of(statement.head[0], kControl) || statement.starts_with("case") ||
               statement.starts_with("default");
    }

    // Whether there is a '=' outside all brackets.
    static bool assigns(const Tokens& tokens) {
        for (std::size_t i = 0; i < tokens.size(); ++i) {
            if (tokens[i].is("(")) i = closing(tokens, i);
            if (i < tokens.size() && tokens[i].is("=")) return true;
        }
        return false;
    }

    void with_block(Statement& statement, bool top_level) {
        const bool record = !statement.head.empty() && is_one_of(statement.head[0], kRecords);
        ++at_;
        statement.has_block = true;
        statement.body = block(false, record && dialect_ == Dialect::wgsl);
        ++at_;
        if (!top_level || !record || dialect_ == Dialect::wgsl) return;
        while (at_ < tokens_.size() && !tokens_[at_].is(";"))
            statement.tail.push_back(tokens_[at_++]);
        statement.end = ";";
        ++at_;
    }

    const Tokens& tokens_;
    Dialect dialect_;
    std::size_t at_ = 0;
};

// The index of the first '(' that is not part of an attribute.
std::size_t parameter_list(const Tokens& head) {
    for (std::size_t i = 1; i < head.size(); ++i) {
        if (!head[i].is("(") || head[i - 1].kind != TokenKind::identifier) continue;
        const bool attribute = head[i - 1].is("__attribute__") || head[i - 1].is("numthreads") ||
                               head[i - 1].is("layout") || (i > 1 && head[i - 2].is("@"));
        if (!attribute) return i;
        i = closing(head, i);
    }
    return head.size();
}

std::size_t find_token(const Tokens& tokens, std::string_view text) {
    const auto found = std::ranges::find(tokens, text, &Token::text);
    return static_cast<std::size_t>(found - tokens.begin());
}

}  // namespace

Statements parse(std::string_view source, Dialect dialect) {
    const Tokens tokens = tokenize(source);
    return Parser{tokens, dialect}.block(true, false);
}

Definition definition_of(const Statement& statement, Dialect dialect) {
    const Tokens& head = statement.head;
    if (head.empty() || statement.is_line()) return {};
    if (statement.starts_with("struct")) return {DefinitionKind::structure, head[1].text};
    if (const std::size_t name = find_token(head, "struct") + 1;
        statement.starts_with("template") && name < head.size())
        return {DefinitionKind::structure, head[name].text};
    if (statement.has_block && std::ranges::none_of(kRecords, [&](std::string_view word) {
            return statement.starts_with(word);
        })) {
        const std::size_t list = parameter_list(head);
        if (list < head.size()) return {DefinitionKind::function, head[list - 1].text};
    }
    const std::size_t equals = find_token(head, "=");
    if (equals == head.size() || statement.has_block) return {DefinitionKind::variable, {}};
    const bool constant = statement.starts_with("const") || statement.starts_with("constant") ||
                          (statement.starts_with("static") && head[1].is("const"));
    if (!constant) return {DefinitionKind::variable, {}};
    std::size_t name = dialect == Dialect::wgsl ? 1 : equals - 1;
    while (name > 1 && head[name].kind != TokenKind::identifier) name -= head[name].is("]") ? 3 : 1;
    return {DefinitionKind::constant, head[name].text};
}

void for_each_list(Statements& statements, const std::function<void(Statements&)>& visit) {
    for (Statement& statement : statements) for_each_list(statement.body, visit);
    visit(statements);
}

void for_each_tokens(Statements& statements, const std::function<void(Tokens&)>& visit) {
    for (Statement& statement : statements) {
        visit(statement.head);
        for_each_tokens(statement.body, visit);
        visit(statement.tail);
    }
}

void for_each_tokens(const Statements& statements,
                     const std::function<void(const Tokens&)>& visit) {
    for (const Statement& statement : statements) {
        visit(statement.head);
        for_each_tokens(statement.body, visit);
        visit(statement.tail);
    }
}

std::size_t count_mentions(const Statement& statement, std::string_view name) {
    std::size_t count = count_mentions(statement.head, name);
    for (const Statement& inner : statement.body) count += count_mentions(inner, name);
    return count;
}

void rename(Statement& statement, std::string_view from, const std::string& to) {
    for (std::size_t i = 0; i < statement.head.size(); ++i)
        if (statement.head[i].is(from) && is_free_name(statement.head, i))
            statement.head[i].text = to;
    rename(statement.body, from, to);
}

void rename(Statements& statements, std::string_view from, const std::string& to) {
    for (Statement& statement : statements) rename(statement, from, to);
}

}  // namespace lacquer::codegen::text
