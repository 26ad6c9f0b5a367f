// Literals, swizzles and assignments of WGSL.
#include <algorithm>
#include <cctype>
#include <optional>

#include "codegen/text/expressions.h"
#include "codegen/text/wgsl.h"

namespace lacquer::codegen::text {

namespace {

bool is_digits(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) {
        return std::isdigit(static_cast<unsigned char>(c)) != 0;
    });
}

bool is_vector(std::string_view type) {
    return type.starts_with("vec");
}

// The component that "2u" means.
std::optional<char> component(const Token& index) {
    constexpr std::string_view kComponents = "xyzw";
    const bool literal = index.text.size() == 2 && index.text[1] == 'u' &&
                         is_digits(index.text.substr(0, 1)) && index.text[0] < '4';
    if (!literal) return std::nullopt;
    return kComponents[static_cast<std::size_t>(index.text[0] - '0')];
}

// The type written from `first` on, up to what ends a declaration.
std::string type_text(const Tokens& tokens, std::size_t first) {
    std::string type;
    int depth = 0;
    for (std::size_t i = first; i < tokens.size(); ++i) {
        if (depth == 0 && (tokens[i].is(",") || tokens[i].is(")") || tokens[i].is("="))) break;
        depth += tokens[i].is("<") ? 1 : 0;
        depth -= tokens[i].is(">") ? 1 : 0;
        type += tokens[i].text;
    }
    return type;
}

// "array<vec4f>" and "array<vec4f,3>" as "vec4f"; vectors give no name, their parts are numbers.
std::string element_type(const std::string& type) {
    if (!type.starts_with("array<")) return {};
    const std::size_t end = std::min(type.rfind(','), type.rfind('>'));
    return type.substr(6, end - 6);
}

void collect_types(const Tokens& tokens, Types& types) {
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i)
        if (tokens[i].kind == TokenKind::identifier && tokens[i + 1].is(":"))
            types[tokens[i].text] = type_text(tokens, i + 2);
}

class SwizzleRestorer {
 public:
    explicit SwizzleRestorer(const Types& types) : types_{types} {}

    void restore(Tokens& tokens) const {
        for (std::size_t i = 0; i < tokens.size(); ++i)
            if (is_free_name(tokens, i)) chain(tokens, i);
        for (std::size_t i = 0; i + 5 < tokens.size(); ++i)
            if (tokens[i].is("bitcast") && tokens[i + 2].is("u32")) conversion(tokens, i);
    }

 private:
    std::string type_of(const std::string& name) const {
        const auto found = types_.find(name);
        return found == types_.end() ? std::string{} : found->second;
    }

    // Follows name.member[index]... and rewrites constant indices of vectors.
    void chain(Tokens& tokens, std::size_t start) const {
        std::string type = type_of(tokens[start].text);
        std::size_t at = start + 1;
        while (at + 1 < tokens.size() && !type.empty()) {
            if (tokens[at].is(".")) {
                type = type_of(type + "." + tokens[at + 1].text);
                at += 2;
            } else if (tokens[at].is("[")) {
                const std::size_t close = closing(tokens, at);
                const auto letter = component(tokens[at + 1]);
                if (is_vector(type) && letter && close == at + 2) {
                    tokens[at].text = ".";
                    tokens[at + 1] = {.kind = TokenKind::identifier,
                                      .text = std::string(1, *letter)};
                    tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(close));
                    return;
                }
                type = element_type(type);
                at = close + 1;
            } else {
                return;
            }
        }
    }

    // bitcast<u32>(x): what converts an integer is `u32(x)`, and `8u` is one already.
    void conversion(Tokens& tokens, std::size_t at) const {
        const std::size_t open = at + 4;
        const std::size_t close = closing(tokens, open);
        if (tokens[open + 1].is("u32") && closing(tokens, open + 2) + 1 == close) {
            const auto begin = tokens.begin() + static_cast<std::ptrdiff_t>(at);
            tokens[open + 1].space = tokens[at].space;
            tokens.erase(tokens.begin() + static_cast<std::ptrdiff_t>(close));
            tokens.erase(begin, begin + 5);
            return;
        }
        if (close != open + 2) return;
        const Token& value = tokens[open + 1];
        const auto first = tokens.begin() + static_cast<std::ptrdiff_t>(at);
        if (value.kind == TokenKind::number && value.text.find('.') == std::string::npos) {
            first->kind = TokenKind::number;
            first->text = value.text.substr(0, value.text.find_first_of("iu")) + "u";
            tokens.erase(first + 1, first + 7);
        } else if (type_of(value.text) == "i32") {
            first->text = "u32";
            tokens.erase(first + 1, first + 4);
        }
    }

    const Types& types_;
};

// Whether `tokens` from `first` on have an operator of `operators` outside all brackets.
bool has_operator(const Tokens& tokens, std::size_t first, std::string_view operators) {
    for (std::size_t i = first; i < tokens.size(); ++i) {
        if (tokens[i].is("(") || tokens[i].is("[")) {
            i = closing(tokens, i);
            continue;
        }
        const bool binary =
            i > first && tokens[i].text.size() == 1 && tokens[i].kind == TokenKind::punctuation;
        if (binary && operators.find(tokens[i].text) != std::string_view::npos) return true;
    }
    return false;
}

// The vector type among those of the names in `value`, outside brackets; a product or a sum with a
// vector is one.
std::string vector_type(const Tokens& value, const Types& types) {
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i].is("(") && i > 0) {
            i = closing(value, i);
            continue;
        }
        const auto found = types.find(value[i].text);
        const bool whole = i + 1 >= value.size() || !value[i + 1].is(".");
        if (whole && is_free_name(value, i) && found != types.end() && is_vector(found->second))
            return found->second;
    }
    return {};
}

// How many of the tokens from `first` on are `name.x, name.y, ...`, counted in components.
std::size_t leading_components(const Tokens& tokens, std::size_t first, std::size_t limit) {
    constexpr std::string_view kComponents = "xyzw";
    std::size_t count = 0;
    for (std::size_t at = first; at + 2 < limit && count < 4; at += 4, ++count) {
        const bool next = tokens[at].is(tokens[first].text) && tokens[at + 1].is(".") &&
                          tokens[at + 2].is(kComponents.substr(count, 1));
        const bool ends = at + 3 == limit || tokens[at + 3].is(",");
        if (!next || !ends) break;
    }
    return count;
}

void join_vectors(Tokens& tokens, const Types& types) {
    for (std::size_t i = 0; i + 6 < tokens.size(); ++i) {
        if (!is_vector(tokens[i].text) || !tokens[i + 1].is("(")) continue;
        const std::size_t close = closing(tokens, i + 1);
        const std::size_t count = leading_components(tokens, i + 2, close);
        const auto type = types.find(tokens[i + 2].text);
        if (count < 2 || type == types.end()) continue;
        if (type->second != "vec" + std::to_string(count) + "f") continue;
        const auto first = tokens.begin() + static_cast<std::ptrdiff_t>(i) + 3;
        tokens.erase(first, first + static_cast<std::ptrdiff_t>(4 * count - 2));
    }
}

void restore_compound(Tokens& head) {
    const auto equals = std::ranges::find(head, "=", &Token::text);
    const auto target = static_cast<std::size_t>(equals - head.begin());
    if (equals == head.end() || head.size() < 2 * target + 3) return;
    for (std::size_t i = 0; i < target; ++i)
        if (head[i].text != head[target + 1 + i].text) return;
    const std::size_t sign = 2 * target + 1;
    const std::string symbol = head[sign].text;
    if (symbol != "+" && symbol != "-" && symbol != "*") return;
    // x + a + b is (x + a) + b, which x += a + b is not.
    if (has_operator(head, sign + 1, symbol == "*" ? "*/+-<>&|" : "+-<>&|")) return;
    head[target].text = symbol + "=";
    const auto first = head.begin() + static_cast<std::ptrdiff_t>(target) + 1;
    head.erase(first, head.begin() + static_cast<std::ptrdiff_t>(sign) + 1);
}

}  // namespace

Types module_types(const Statements& statements) {
    Types types;
    for (const Statement& statement : statements) {
        if (statement.starts_with("struct")) {
            Types members;
            for (const Statement& member : statement.body) collect_types(member.head, members);
            for (const auto& [name, type] : members)
                types[statement.head[1].text + "." + name] = type;
        } else if (!statement.has_block) {
            collect_types(statement.head, types);
        } else if (const auto name = definition_of(statement, Dialect::wgsl).name; !name.empty()) {
            for (std::size_t i = 0; i + 1 < statement.head.size(); ++i)
                if (statement.head[i].is("->")) types[name] = type_text(statement.head, i + 1);
        }
    }
    return types;
}

Types function_types(const Statement& function, const Types& module) {
    Types types = module;
    collect_types(function.head, types);
    for (const Statement& statement : function.body)
        if (statement.starts_with("var")) collect_types(statement.head, types);
    return types;
}

void restore_swizzles(Statement& function, const Types& types) {
    const SwizzleRestorer restorer{types};
    for_each_tokens(function.body, [&](Tokens& tokens) { restorer.restore(tokens); });
}

void join_vectors(Statement& function, const Types& types) {
    Types known = types;
    for_each_list(function.body, [&](Statements& list) {
        for (Statement& statement : list) {
            if (!statement.starts_with("let") || statement.head.size() < 4) continue;
            const Tokens value{statement.head.begin() + 3, statement.head.end()};
            known[statement.head[1].text] = vector_type(value, known);
        }
    });
    for_each_tokens(function.body, [&](Tokens& tokens) { join_vectors(tokens, known); });
}

void restore_compound_assignments(Statement& function) {
    for_each_tokens(function.body, restore_compound);
}

void restore_literals(Tokens& tokens) {
    for (Token& token : tokens) {
        if (token.kind != TokenKind::number || token.text.starts_with("0x")) continue;
        const char suffix = token.text.back();
        if (suffix == 'f') {
            token.text = shortest_float(token.text);
            token.text.pop_back();
        } else if (suffix == 'i') {
            token.text.pop_back();
        }
    }
}

void parenthesize_conditions(Statement& function) {
    for_each_list(function.body, [](Statements& list) {
        for (Statement& statement : list) {
            Tokens& head = statement.head;
            if (!statement.starts_with("if") || head.size() < 2) continue;
            if (head[1].is("(") && closing(head, 1) == head.size() - 1) continue;
            head[1].space = false;
            head.insert(head.begin() + 1, {.text = "(", .space = true});
            head.push_back({.text = ")"});
        }
    });
}

}  // namespace lacquer::codegen::text
