// `c ? a : b` as translators write it, and back.
#include <algorithm>

#include "codegen/names.h"
#include "codegen/text/locals.h"

namespace lacquer::codegen::text {

namespace {

bool is_selected(const Token& token) {
    return token.text.starts_with(kSelectedName);
}

// The name assigned by `NAME = ...;`, where it is one of kSelectedName; nothing otherwise.
std::string selected_by(const Statement& statement) {
    const Tokens& head = statement.head;
    const bool assigns = !statement.has_block && head.size() > 2 && head[1].is("=");
    return assigns && is_selected(head[0]) ? head[0].text : std::string{};
}

void append(Tokens& tokens, Tokens more, bool space) {
    more.front().space = space;
    tokens.insert(tokens.end(), more.begin(), more.end());
}

// An operand of `?:` or of another operator, in parentheses; those not needed go later.
Tokens parenthesized(Tokens tokens) {
    tokens.front().space = false;
    tokens.insert(tokens.begin(), Token{.text = "("});
    tokens.push_back(Token{.text = ")"});
    return tokens;
}

// if (c) { s = a; } else { s = b; } becomes s = (c) ? (a) : (b);
bool join_branches(Statements& list) {
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
        const Statement& yes = list[i];
        const Statement& no = list[i + 1];
        if (!yes.starts_with("if") || !no.starts_with("else") || no.head.size() != 1) continue;
        if (yes.body.size() != 1 || no.body.size() != 1) continue;
        const std::string name = selected_by(yes.body[0]);
        if (name.empty() || selected_by(no.body[0]) != name) continue;
        Statement joined;
        joined.end = ";";
        joined.head = slice(yes.body[0].head, 0, 2);
        append(joined.head, slice(yes.head, 1, yes.head.size()), true);
        joined.head.push_back({.text = "?", .space = true});
        const auto value = [](const Statement& branch) {
            return parenthesized(slice(branch.body[0].head, 2, branch.body[0].head.size()));
        };
        append(joined.head, value(yes), true);
        joined.head.push_back({.text = ":", .space = true});
        append(joined.head, value(no), true);
        list[i] = joined;
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        return true;
    }
    return false;
}

// Puts the value of `s = ...;` in the place of s in the next statement, where that is its only use.
bool substitute(Statements& list, const Statement& function) {
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
        const std::string name = selected_by(list[i]);
        Statement& next = list[i + 1];
        // A declaration, this assignment, one use.
        if (name.empty() || count_mentions(function, name) != 3) continue;
        if (count_mentions(next.head, name) != 1 || next.starts_with("for")) continue;
        const auto use = std::ranges::find(next.head, name, &Token::text);
        Tokens value = parenthesized(slice(list[i].head, 2, list[i].head.size()));
        value.front().space = use->space;
        const auto at = next.head.erase(use);
        next.head.insert(at, value.begin(), value.end());
        list.erase(list.begin() + static_cast<std::ptrdiff_t>(i));
        return true;
    }
    return false;
}

// Declarations of names that nothing else mentions.
void drop_unused(Statement& function) {
    for_each_list(function.body, [&](Statements& list) {
        std::erase_if(list, [&](const Statement& statement) {
            return !statement.has_block && !statement.head.empty() &&
                   is_selected(statement.head.back()) &&
                   count_mentions(function, statement.head.back().text) == 1;
        });
    });
}

}  // namespace

void restore_choices(Statement& function) {
    for (bool changed = true; changed;) {
        changed = false;
        for_each_list(function.body, [&](Statements& list) {
            changed = join_branches(list) || changed;
            changed = substitute(list, function) || changed;
        });
        drop_unused(function);
    }
}

}  // namespace lacquer::codegen::text
