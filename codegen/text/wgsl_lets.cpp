// Where naga's `let`s and choices go.
#include <algorithm>
#include <cctype>
#include <optional>

#include "codegen/names.h"
#include "codegen/text/wgsl.h"

namespace lacquer::codegen::text {

namespace {

bool is_naga_name(const std::string& name) {
    return name.size() > 2 && name.starts_with("_e") &&
           std::isdigit(static_cast<unsigned char>(name[2])) != 0;
}

// The name that `let name = ...;` introduces, where naga chose it.
std::string naga_let(const Statement& statement) {
    const bool let = statement.starts_with("let") && statement.head.size() > 3;
    return let && is_naga_name(statement.head[1].text) ? statement.head[1].text : std::string{};
}

// Whether `statement` or anything within writes to the variable `name`.
bool writes(const Statement& statement, const std::string& name) {
    const Tokens& head = statement.head;
    const bool assigns = !statement.has_block && !head.empty() && head[0].is(name);
    if (assigns) return true;
    for (std::size_t i = 0; i + 1 < head.size(); ++i)
        if (head[i].is("&") && head[i + 1].is(name)) return true;
    return std::ranges::any_of(statement.body,
                               [&](const Statement& inner) { return writes(inner, name); });
}

// What the value of a `let` depends on.
struct Reads {
    std::vector<std::string> names;
    bool module = false;  // variables of the module, directly or through a call
};

Reads reads_of(const Tokens& value, const ModuleVariables& variables) {
    Reads reads;
    for (std::size_t i = 0; i < value.size(); ++i) {
        if (!is_free_name(value, i)) continue;
        reads.names.push_back(value[i].text);
        const bool call = i + 1 < value.size() && value[i + 1].is("(");
        reads.module = reads.module || call || variables.contains(value[i].text);
    }
    return reads;
}

bool interferes(const Statement& statement, const Reads& reads, const ModuleVariables& variables) {
    const auto written = [&](const std::string& name) { return writes(statement, name); };
    return std::ranges::any_of(reads.names, written) ||
           (reads.module && std::ranges::any_of(variables, written));
}

// Inlines the `let` at `index` where that is safe: all its uses in heads of later statements of the
// same list, before anything that it reads is written; once only, unless it is a mere load.
bool inline_let(Statements& list, std::size_t index, const Statement& function,
                const ModuleVariables& variables) {
    const std::string name = naga_let(list[index]);
    if (name.empty()) return false;
    const Tokens value{list[index].head.begin() + 3, list[index].head.end()};
    const Reads reads = reads_of(value, variables);
    std::size_t left = count_mentions(function, name) - 1;
    const bool load = std::ranges::none_of(value, [](const Token& t) { return t.is("("); });
    if (left > 1 && !load) return false;
    std::vector<std::size_t> places;
    for (std::size_t i = index + 1; i < list.size() && left > 0; ++i) {
        const std::size_t here = count_mentions(list[i].head, name);
        if (here > 0) places.push_back(i);
        left -= here;
        if (left > 0 && interferes(list[i], reads, variables)) return false;
    }
    if (left > 0) return false;
    for (const std::size_t place : places) substitute(list[place].head, name, value);
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(index));
    return true;
}

bool is_selected(const Token& token) {
    return token.text.starts_with(kSelectedName);
}

// `receiver = selected;`
bool passes_on(const Statement& statement) {
    const Tokens& head = statement.head;
    return !statement.has_block && head.size() == 3 && head[1].is("=") && is_selected(head[2]);
}

struct Choice {
    std::string selected;
    std::string receiver;
};

std::optional<Choice> find_choice(const Statements& statements) {
    for (const Statement& statement : statements) {
        if (passes_on(statement)) return Choice{statement.head[2].text, statement.head[0].text};
        if (const auto inner = find_choice(statement.body)) return inner;
    }
    return std::nullopt;
}

}  // namespace

void inline_lets(Statement& function, const ModuleVariables& variables) {
    for_each_list(function.body, [&](Statements& list) {
        for (std::size_t i = 0; i < list.size();)
            if (!inline_let(list, i, function, variables)) ++i;
    });
}

void merge_choices(Statement& function) {
    while (const auto choice = find_choice(function.body)) {
        const auto& [selected, receiver] = *choice;
        for_each_list(function.body, [&](Statements& list) {
            std::erase_if(list, [&](const Statement& statement) {
                const Tokens& head = statement.head;
                const bool declares = statement.starts_with("var") && head[1].is(selected);
                return declares || (passes_on(statement) && head[2].is(selected));
            });
        });
        rename(function.body, selected, receiver);
    }
    for_each_list(function.body, [&](Statements& list) {
        for (Statement& statement : list) {
            const Tokens& head = statement.head;
            if (head.size() != 2 || !head[0].is("return") || !is_selected(head[1])) continue;
            const std::string selected = head[1].text;
            if (count_mentions(function, "result") == 0) rename(function.body, selected, "result");
        }
    });
}

}  // namespace lacquer::codegen::text
