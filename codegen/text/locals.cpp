#include "codegen/text/locals.h"

#include <algorithm>
#include <cctype>
#include <regex>

#include "codegen/names.h"

namespace lacquer::codegen::text {

namespace {

// The part before `_1`; nothing where there is no such end.
std::string base_of(const std::string& name) {
    static const std::regex kNumbered{R"((.*[A-Za-z])_\d+)"};
    std::smatch match;
    return std::regex_match(name, match, kNumbered) ? match[1].str() : std::string{};
}

// The name declared by the tokens from `first` on; nothing where they declare none.
std::string declared_by(const Tokens& tokens, std::size_t first, Dialect dialect) {
    if (first + 1 >= tokens.size()) return {};
    if (dialect == Dialect::wgsl) {
        const bool declares = tokens[first].is("let") || tokens[first].is("var");
        return declares ? tokens[first + 1].text : std::string{};
    }
    if (tokens[first].is("return") || tokens[first].is("else")) return {};
    for (std::size_t i = first; i + 1 < tokens.size(); ++i) {
        if (tokens[i].kind != TokenKind::identifier) return {};
        if (tokens[i + 1].kind == TokenKind::identifier) continue;
        const bool ends = tokens[i + 1].is("=") || tokens[i + 1].is("[");
        return i > first && ends ? tokens[i].text : std::string{};
    }
    return tokens.size() - first > 1 && tokens.back().kind == TokenKind::identifier
               ? tokens.back().text
               : std::string{};
}

std::string declared_by(const Statement& statement, Dialect dialect) {
    const bool loop = statement.starts_with("for") && statement.head.size() > 2;
    if (statement.has_block && !loop) return {};
    return declared_by(statement.head, loop ? 2 : 0, dialect);
}

class NameRestorer {
 public:
    NameRestorer(Dialect dialect, const std::vector<std::string>& reserved)
        : dialect_{dialect}, reserved_{reserved} {}

    void function(Statement& function) {
        std::vector<std::string> visible;
        Tokens& head = function.head;
        for (std::size_t i = 0; i + 1 < head.size(); ++i) {
            if (head[i].kind != TokenKind::identifier) continue;
            if (dialect_ == Dialect::wgsl && head[i + 1].is(":")) {
                const std::string base = base_of(head[i].text);
                if (is_free(base, visible) && count_mentions(function, base) == 0)
                    rename(function, std::string{head[i].text}, base);
            }
            visible.push_back(head[i].text);
        }
        list(function.body, visible);
    }

 private:
    bool is_free(const std::string& base, const std::vector<std::string>& visible) const {
        return !base.empty() && std::ranges::find(visible, base) == visible.end() &&
               std::ranges::find(reserved_, base) == reserved_.end();
    }

    void list(Statements& statements, std::vector<std::string> visible) {
        for (std::size_t i = 0; i < statements.size(); ++i) {
            std::string name = declared_by(statements[i], dialect_);
            const std::string base = base_of(name);
            const std::size_t end = statements[i].has_block ? i + 1 : statements.size();
            if (is_free(base, visible) && !mentioned(statements, i, end, base)) {
                for (std::size_t k = i; k < end; ++k) rename(statements[k], name, base);
                name = base;
            }
            std::vector<std::string> inner = visible;
            if (!name.empty()) inner.push_back(name);
            list(statements[i].body, inner);
            if (!statements[i].has_block) visible = inner;
        }
    }

    static bool mentioned(const Statements& statements, std::size_t first, std::size_t last,
                          const std::string& name) {
        for (std::size_t i = first; i < last; ++i)
            if (count_mentions(statements[i], name) > 0) return true;
        return false;
    }

    Dialect dialect_;
    const std::vector<std::string>& reserved_;
};

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

// What glslang calls the copy of a value that it indexes.
constexpr std::string_view kCopyName = "indexable";

// What the translator calls a value that has no name in the source.
bool is_nameless(const std::string& name) {
    const bool number = name.size() > 1 && name[0] == '_' && is_digit(name[1]);
    const bool naga = name.size() > 2 && name.starts_with("_e") && is_digit(name[2]);
    const bool phi = name.starts_with("phi_") && name.ends_with('_');
    return number || naga || phi || name.starts_with(kSelectedName) || name.starts_with(kCopyName);
}

// Whether anything in `statement` stores to `name`, or might.
bool may_write(const Statement& statement, const std::string& name) {
    const Tokens& head = statement.head;
    for (std::size_t i = 0; i < head.size(); ++i) {
        if (!head[i].is(name) || !is_free_name(head, i)) continue;
        const bool passed = i > 0 && head[i - 1].is("&");
        const bool counted = head.size() == 2 && (head[1].is("++") || head[1].is("--"));
        std::size_t after = i + 1;
        while (after < head.size() && (head[after].is("[") || head[after].is(".")))
            after = head[after].is("[") ? closing(head, after) + 1 : after + 2;
        const bool set = i == 0 && after < head.size() && head[after].text.ends_with('=');
        if (passed || counted || set) return true;
    }
    return std::ranges::any_of(statement.body,
                               [&](const Statement& inner) { return may_write(inner, name); });
}

// The name that `T indexable = name;` or `copy(indexable, name);` copies; nothing otherwise.
std::string copied_by(const Statement& statement, const std::string& copy) {
    const Tokens& head = statement.head;
    if (head.size() < 3 || head.back().kind == TokenKind::number) return {};
    const Token& before = head[head.size() - 2];
    if (before.is("=") && head.back().kind == TokenKind::identifier && mentions(head, copy))
        return head.back().text;
    const bool call =
        head[0].text.starts_with("spvArrayCopy") && head.size() == 6 && head[2].is(copy);
    return call ? head[4].text : std::string{};
}

// Puts `value` in the place of `name` in the statement and all within.
void substitute(Statement& statement, const std::string& name, const Tokens& value) {
    text::substitute(statement.head, name, value);
    for (Statement& inner : statement.body) substitute(inner, name, value);
}

// "LqPlainSurface" as "plain_surface".
std::string snake_case(std::string_view type) {
    if (type.starts_with("Lq")) type.remove_prefix(2);
    std::string name;
    for (const char c : type) {
        const bool upper = std::isupper(static_cast<unsigned char>(c)) != 0;
        if (upper && !name.empty()) name += '_';
        name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return name;
}

// `wished`, or it with a letter at its end where the function knows that name already.
std::string unused_name(const Statement& function, const std::string& wished) {
    if (count_mentions(function, wished) == 0) return wished;
    for (char letter = 'b'; letter <= 'z'; ++letter) {
        const std::string name = wished + '_' + letter;
        if (count_mentions(function, name) == 0) return name;
    }
    return wished + "_more";
}

}  // namespace

void restore_names(Statement& function, Dialect dialect, const std::vector<std::string>& reserved) {
    NameRestorer{dialect, reserved}.function(function);
}

void inline_constants(Statement& function, Dialect dialect) {
    for_each_list(function.body, [&](Statements& list) {
        for (std::size_t i = 0; i < list.size();) {
            const std::string name = declared_by(list[i], dialect);
            const Tokens& head = list[i].head;
            const auto equals = std::ranges::find(head, "=", &Token::text);
            const Tokens value{equals == head.end() ? equals : equals + 1, head.end()};
            const bool constant = !value.empty() && std::ranges::all_of(value, [](const Token& t) {
                return t.kind != TokenKind::identifier || t.text.starts_with("LQ_");
            });
            if (!is_nameless(name) || !constant || value[0].is("{")) {
                ++i;
                continue;
            }
            for (std::size_t k = i + 1; k < list.size(); ++k) substitute(list[k], name, value);
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
        }
    });
}

void name_locals(Statement& function, Dialect dialect) {
    for_each_list(function.body, [&](Statements& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            const std::string name = declared_by(list[i], dialect);
            if (!is_nameless(name)) continue;
            const bool returned = i + 1 < list.size() && list[i + 1].head.size() == 2 &&
                                  list[i + 1].starts_with("return") && list[i + 1].head[1].is(name);
            const bool record = list[i].head[0].text.starts_with("Lq");
            const std::string type = record ? snake_case(list[i].head[0].text) : "values";
            const std::string wished = returned ? "result"
                                       : name.starts_with(kSelectedName) || name.starts_with("phi_")
                                           ? "selected"
                                       : dialect == Dialect::wgsl ? "value"
                                                                  : type;
            rename(function.body, name, unused_name(function, wished));
        }
    });
}

void drop_copies(Statement& function, Dialect dialect) {
    for_each_list(function.body, [&](Statements& list) {
        for (std::size_t i = 0; i < list.size();) {
            const std::string copy = declared_by(list[i], dialect);
            const bool apart = i + 1 < list.size() && copied_by(list[i], copy).empty();
            const std::size_t last = apart ? i + 1 : i;
            const std::string name = copy.starts_with(kCopyName) ? copied_by(list[last], copy) : "";
            const auto written = [&](const Statement& statement) {
                return may_write(statement, name) || may_write(statement, copy);
            };
            const auto rest = list.begin() + static_cast<std::ptrdiff_t>(last) + 1;
            if (name.empty() || std::any_of(rest, list.end(), written)) {
                ++i;
                continue;
            }
            for (auto statement = rest; statement != list.end(); ++statement)
                rename(*statement, copy, name);
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(i), rest);
        }
    });
}

void name_built_ins(Statement& function, Dialect dialect) {
    for (Statement& statement : function.body) {
        const std::string name = declared_by(statement, dialect);
        const std::string base = base_of(name);
        if (!base.starts_with("gl_")) continue;
        rename(function.body, name, unused_name(function, snake_case(base.substr(3))));
    }
}

void join_else_if(Statements& statements) {
    for_each_list(statements, [](Statements& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            Statement& outer = list[i];
            if (!outer.starts_with("else") || outer.head.size() != 1 || outer.body.empty())
                continue;
            const Statements& inner = outer.body;
            const bool chain = inner[0].starts_with("if") &&
                               std::all_of(inner.begin() + 1, inner.end(), [](const Statement& s) {
                                   return s.starts_with("else");
                               });
            if (!chain) continue;
            Statements joined = inner;
            joined[0].head.front().space = true;
            joined[0].head.insert(joined[0].head.begin(), outer.head.front());
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
            list.insert(list.begin() + static_cast<std::ptrdiff_t>(i), joined.begin(),
                        joined.end());
        }
    });
}

}  // namespace lacquer::codegen::text
