// Where WGSL's variables are declared, and its loops.
#include <algorithm>

#include "codegen/text/wgsl.h"

namespace lacquer::codegen::text {

namespace {

// `var name: type;` without a value, as naga writes it at the top of a function.
bool is_bare_variable(const Statement& statement) {
    const Tokens& head = statement.head;
    return statement.starts_with("var") && head.size() > 3 && head[2].is(":") &&
           std::ranges::none_of(head, [](const Token& token) { return token.is("="); });
}

// Whether anything in `statement` stores to `name` or to a part of it.
std::size_t count_stores(const Statement& statement, const std::string& name) {
    std::size_t count = 0;
    const Tokens& head = statement.head;
    if (!statement.has_block && !head.empty() && head[0].is(name)) ++count;
    for (std::size_t i = 0; i + 1 < head.size(); ++i)
        if (head[i].is("&") && head[i + 1].is(name)) ++count;
    for (const Statement& inner : statement.body) count += count_stores(inner, name);
    return count;
}

// The innermost list that holds all mentions of `name`, not looking into loops unless the first
// thing done there is to set it.
struct Place {
    Statements* list = nullptr;
    std::size_t index = 0;  // of the first statement that mentions it
};

bool sets_whole(const Statement& statement, const std::string& name) {
    return !statement.has_block && statement.head.size() > 2 && statement.head[0].is(name) &&
           statement.head[1].is("=") && count_mentions(statement.head, name) == 1;
}

Place find_place(Statements& list, const std::string& name) {
    std::vector<std::size_t> mentioning;
    for (std::size_t i = 0; i < list.size(); ++i)
        if (count_mentions(list[i], name) > 0) mentioning.push_back(i);
    if (mentioning.empty()) return {};
    const Place here{&list, mentioning.front()};
    Statement& only = list[mentioning.front()];
    if (mentioning.size() > 1 || !only.has_block || mentions(only.head, name)) return here;
    const Place inner = find_place(only.body, name);
    const bool fresh = inner.list != nullptr && sets_whole((*inner.list)[inner.index], name);
    // Declared inside a loop, a variable forgets its value from one turn to the next.
    return only.starts_with("loop") && !fresh ? here : inner;
}

void declare_at(const Place& place, const Statement& declaration, bool constant) {
    Statement& first = (*place.list)[place.index];
    const std::string name = declaration.head[1].text;
    if (sets_whole(first, name)) {
        first.head.front().space = true;
        first.head.insert(first.head.begin(),
                          {.kind = TokenKind::identifier, .text = constant ? "let" : "var"});
        return;
    }
    place.list->insert(place.list->begin() + static_cast<std::ptrdiff_t>(place.index), declaration);
}

bool is_word(const Statement& statement, std::string_view word) {
    return !statement.has_block && statement.head.size() == 1 && statement.head[0].is(word);
}

bool has_continue(const Statements& statements) {
    return std::ranges::any_of(statements, [](const Statement& statement) {
        return is_word(statement, "continue") || has_continue(statement.body);
    });
}

// loop { if c { ...; continue; } else { break; } ... }
bool starts_with_test(const Statement& loop) {
    if (!loop.starts_with("loop") || loop.body.size() < 2) return false;
    const Statement& test = loop.body[0];
    const Statement& otherwise = loop.body[1];
    return test.starts_with("if") && !test.body.empty() && is_word(test.body.back(), "continue") &&
           otherwise.starts_with("else") && otherwise.body.size() == 1 &&
           is_word(otherwise.body[0], "break");
}

Statement while_loop(const Statement& loop) {
    Statement result = loop.body[0];
    result.head.front().text = "while";
    result.body.pop_back();
    return result;
}

// loop { if c { ...; continue; } else { break; } continuing { ...; update; } }, where only one of
// the two parts before the update has statements that could meet a `continue`.
bool has_for_shape(const Statement& loop) {
    if (!starts_with_test(loop) || loop.body.size() != 3) return false;
    const Statement& test = loop.body[0];
    const Statement& continuing = loop.body[2];
    if (!continuing.starts_with("continuing") || continuing.body.empty()) return false;
    const Statement& update = continuing.body.back();
    const Statements body{test.body.begin(), test.body.end() - 1};
    const bool joined = continuing.body.size() > 1 && has_continue(body);
    return !update.has_block && mentions(test.head, update.head[0].text) && !joined;
}

void append(Tokens& tokens, const Tokens& more, bool space) {
    const std::size_t at = tokens.size();
    tokens.insert(tokens.end(), more.begin(), more.end());
    if (tokens.size() > at) tokens[at].space = space;
}

Statement for_loop(const Statement& loop, const Tokens& start) {
    Statement result;
    result.has_block = true;
    result.head = tokenize("for (");
    append(result.head, start, false);
    result.head.push_back({.text = ";"});
    const Tokens& test = loop.body[0].head;
    Tokens condition{test.begin() + 1, test.end()};
    append(result.head, condition, true);
    result.head.push_back({.text = ";"});
    const Statements& continuing = loop.body[2].body;
    append(result.head, continuing.back().head, true);
    result.head.push_back({.text = ")"});
    result.body = loop.body[0].body;
    result.body.pop_back();
    result.body.insert(result.body.end(), continuing.begin(), continuing.end() - 1);
    return result;
}

}  // namespace

void place_variables(Statement& function) {
    Statements& body = function.body;
    Statements declarations;
    std::ranges::copy_if(body, std::back_inserter(declarations), is_bare_variable);
    std::erase_if(body, is_bare_variable);
    for (const Statement& declaration : declarations) {
        const std::string name = declaration.head[1].text;
        const Place place = find_place(body, name);
        if (place.list == nullptr) continue;  // never used
        std::size_t stores = 0;
        for (const Statement& statement : body) stores += count_stores(statement, name);
        declare_at(place, declaration, stores == 1);
    }
}

void restore_loops(Statement& function) {
    for_each_list(function.body, [](Statements& list) {
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (starts_with_test(list[i]) && list[i].body.size() == 2)
                list[i] = while_loop(list[i]);
            if (!has_for_shape(list[i])) continue;
            Tokens start;
            const bool declared = i > 0 && list[i - 1].starts_with("var") &&
                                  list[i - 1].head.size() > 3 && list[i - 1].head[2].is("=");
            if (declared) {
                const std::string name = list[i - 1].head[1].text;
                bool used_later = false;
                for (std::size_t k = i + 1; k < list.size(); ++k)
                    used_later = used_later || count_mentions(list[k], name) > 0;
                if (!used_later && mentions(list[i].body[0].head, name)) start = list[i - 1].head;
            }
            list[i] = for_loop(list[i], start);
            if (start.empty()) continue;
            list.erase(list.begin() + static_cast<std::ptrdiff_t>(i) - 1);
            --i;
        }
    });
}

}  // namespace lacquer::codegen::text
