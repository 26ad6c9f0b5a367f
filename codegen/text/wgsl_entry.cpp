// The entry point of a WGSL module, from naga's two functions and the globals between them.
#include <algorithm>

#include "codegen/text/wgsl.h"

namespace lacquer::codegen::text {

namespace {

constexpr std::string_view kOuter = "main";
constexpr std::string_view kInner = "main_1";

Statement* find_function(Statements& statements, std::string_view name) {
    const auto found = std::ranges::find_if(statements, [&](const Statement& statement) {
        return definition_of(statement, Dialect::wgsl).name == name;
    });
    return found == statements.end() ? nullptr : &*found;
}

bool is_return(const Statement& statement) {
    return !statement.has_block && statement.starts_with("return");
}

std::size_t count_returns(const Statements& statements) {
    std::size_t count = 0;
    for (const Statement& statement : statements)
        count += (is_return(statement) ? 1 : 0) + count_returns(statement.body);
    return count;
}

// The outer function: what is set before the call, and what follows it.
struct Frame {
    Statements before;
    Statements after;
};

Frame split_at_call(const Statements& body) {
    const auto call = std::ranges::find_if(
        body, [](const Statement& statement) { return statement.starts_with(kInner); });
    if (call == body.end()) return {};
    return {{body.begin(), call}, {call + 1, body.end()}};
}

// `var<private> name: type;` as a variable of a function.
Statement as_local(const Statement& global) {
    Statement local = global;
    const auto open = std::ranges::find(local.head, "<", &Token::text);
    if (open != local.head.end()) local.head.erase(open, open + 3);
    return local;
}

bool is_private(const Statement& statement) {
    return statement.starts_with("var") && statement.head.size() > 4 &&
           statement.head[2].is("private");
}

// Private variables that no function but the two mentions.
Statements entry_variables(const Statements& statements) {
    Statements found;
    for (const Statement& global : statements) {
        if (!is_private(global)) continue;
        const std::string& name = global.head[4].text;
        const bool shared = std::ranges::any_of(statements, [&](const Statement& other) {
            const std::string function = definition_of(other, Dialect::wgsl).name;
            return other.has_block && function != kOuter && function != kInner &&
                   count_mentions(other, name) > 0;
        });
        if (!shared) found.push_back(global);
    }
    return found;
}

// Puts the one statement that ends the outer function in the place of every `return`.
void return_from(Statements& statements, const Statement& last) {
    for (Statement& statement : statements) {
        if (is_return(statement)) statement.head = last.head;
        return_from(statement.body, last);
    }
}

}  // namespace

void join_entry_point(Statements& statements) {
    Statement* outer = find_function(statements, kOuter);
    const Statement* inner = find_function(statements, kInner);
    if (outer == nullptr || inner == nullptr) return;
    inline_lets(*outer, {});
    const Frame frame = split_at_call(outer->body);
    Statements body = inner->body;
    if (!body.empty() && is_return(body.back())) body.pop_back();
    if (count_returns(body) > 0 && frame.after.size() > 1) return;
    if (frame.after.size() == 1) return_from(body, frame.after[0]);

    Statements joined;
    const Statements variables = entry_variables(statements);
    for (const Statement& global : variables) joined.push_back(as_local(global));
    joined.insert(joined.end(), frame.before.begin(), frame.before.end());
    joined.insert(joined.end(), body.begin(), body.end());
    joined.insert(joined.end(), frame.after.begin(), frame.after.end());
    outer->body = joined;
    std::erase_if(statements, [&](const Statement& statement) {
        const bool local = std::ranges::any_of(variables, [&](const Statement& variable) {
            return is_private(statement) && statement.head[4].text == variable.head[4].text;
        });
        return local || definition_of(statement, Dialect::wgsl).name == kInner;
    });
}

}  // namespace lacquer::codegen::text
