#include "codegen/arrange.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "codegen/emit.h"
#include "codegen/text/expressions.h"

namespace lacquer::codegen {

namespace {

using text::DefinitionKind;
using text::Dialect;
using text::Statement;
using text::Statements;

constexpr std::string_view kEntryPoints[] = {"main", "main0"};

bool is_entry_point(const std::string& name) {
    return std::ranges::find(kEntryPoints, name) != std::end(kEntryPoints);
}

// The type `type` of GLSL; constants are scalars.
std::string scalar_type(const std::string& type, Dialect dialect) {
    if (dialect != Dialect::wgsl) return type;
    if (type == "float") return "f32";
    return type == "int" ? "i32" : "u32";
}

Statement constant_definition(const Declaration& declaration, Dialect dialect) {
    const std::string type = scalar_type(declaration.type, dialect);
    std::string value = declaration.value;
    if (type == "float" || type == "f32") {
        const bool negative = value.starts_with('-');
        const std::string digits = text::shortest_float(value.substr(negative ? 1 : 0));
        value = fmt::format("{}{}", negative ? "-" : "", digits);
        if (dialect == Dialect::hlsl) value += "f";
    }
    const std::string& name = declaration.name;
    const std::string line = [&] {
        switch (dialect) {
            case Dialect::glsl:
                return fmt::format("const {} {} = {}", type, name, value);
            case Dialect::hlsl:
                return fmt::format("static const {} {} = {}", type, name, value);
            case Dialect::msl:
                return fmt::format("constant {} {} = {}", type, name, value);
            case Dialect::wgsl:
                return fmt::format("const {}: {} = {}", name, type, value);
        }
        return std::string{};
    }();
    return {.head = text::tokenize(line), .end = std::string{";"}};
}

// A number, perhaps negative: what a constant needs to be written anew.
bool is_literal(const std::string& value) {
    const std::string digits = value.starts_with('-') ? value.substr(1) : value;
    const text::Tokens tokens = text::tokenize(digits);
    return tokens.size() == 1 && tokens[0].kind == text::TokenKind::number;
}

// Translated definitions by name.
class Definitions {
 public:
    Definitions(const Statements& statements, Dialect dialect) : dialect_{dialect} {
        for (const Statement& statement : statements) {
            const text::Definition definition = definition_of(statement, dialect);
            if (!definition.name.empty()) by_name_[definition.name] = statement;
        }
    }

    // The definition of what `declaration` declares, documented; nothing where the translator did
    // not need it, but for constants where `all_constants` are wanted.
    Statements find(const Declaration& declaration, bool all_constants) const {
        const auto place = by_name_.find(declaration.name);
        const bool translated = place != by_name_.end();
        const bool literal =
            declaration.kind == Declaration::Kind::constant && is_literal(declaration.value);
        if (!translated && !(literal && all_constants)) return {};
        Statement found = literal ? constant_definition(declaration, dialect_) : place->second;
        found.above.insert(found.above.begin(), declaration.comment.begin(),
                           declaration.comment.end());
        found.gap = declaration.starts_group;
        return {found};
    }

 private:
    Dialect dialect_;
    std::map<std::string, Statement> by_name_;
};

// What the translator defines for itself.
bool is_helper(const text::Definition& definition) {
    return definition.name.starts_with("spv") || definition.name.starts_with(kTableName);
}

std::set<std::string> declared_names(const std::vector<SourceModule>& modules) {
    std::set<std::string> names;
    for (const SourceModule& module : modules)
        for (const Declaration& declaration : module.declarations) names.insert(declaration.name);
    return names;
}

// Definitions of the translator that `kept` mentions, directly or through others.
Statements needed_helpers(const Statements& translated, const Statements& kept, Dialect dialect) {
    Statements helpers;
    for (auto statement = translated.rbegin(); statement != translated.rend(); ++statement) {
        const text::Definition definition = definition_of(*statement, dialect);
        if (!is_helper(definition)) continue;
        const auto mentions = [&](const Statement& other) {
            return count_mentions(other, definition.name) > 0;
        };
        if (std::ranges::any_of(kept, mentions) || std::ranges::any_of(helpers, mentions))
            helpers.insert(helpers.begin(), *statement);
    }
    return helpers;
}

// The same without the definitions of the translator that nothing mentions.
Statements without_needless_helpers(Statements translated, Dialect dialect) {
    Statements kept;
    std::ranges::copy_if(translated, std::back_inserter(kept), [&](const Statement& statement) {
        return !is_helper(definition_of(statement, dialect));
    });
    std::set<std::string> needed;
    for (const Statement& helper : needed_helpers(translated, kept, dialect))
        needed.insert(definition_of(helper, dialect).name);
    std::erase_if(translated, [&](const Statement& statement) {
        const text::Definition definition = definition_of(statement, dialect);
        return is_helper(definition) && !needed.contains(definition.name);
    });
    return translated;
}

// What stands above all definitions: directives, precisions, the size of a workgroup.
bool is_opening(const Statement& statement) {
    const bool layout =
        statement.starts_with("layout") && statement.head.back().is("in") && !statement.has_block;
    return statement.is_line() || statement.starts_with("using") ||
           statement.starts_with("precision") || layout;
}

void append(Statements& list, const Statements& more) {
    list.insert(list.end(), more.begin(), more.end());
}

// The definitions of one module under the comment that opens its file.
Statements module_definitions(const SourceModule& module, const Definitions& definitions) {
    Statements found;
    for (const Declaration& declaration : module.declarations)
        append(found, definitions.find(declaration, true));
    if (found.empty() || module.head.empty()) return found;
    Statement head;
    head.above = module.head;
    head.gap = true;
    found.front().gap = true;
    found.insert(found.begin(), head);
    return found;
}

}  // namespace

Statements arrange_library(Statements translated, const std::vector<SourceModule>& modules,
                           Dialect dialect) {
    const Definitions definitions{translated, dialect};
    Statements kept;
    for (const SourceModule& module : modules)
        append(kept, module_definitions(module, definitions));
    Statements arranged;
    for (const Statement& statement : translated)
        if (dialect == Dialect::msl && is_opening(statement)) arranged.push_back(statement);
    append(arranged, needed_helpers(translated, kept, dialect));
    append(arranged, kept);
    return arranged;
}

Statements arrange_kernel(Statements translated, const std::vector<SourceModule>& modules,
                          Dialect dialect) {
    translated = without_needless_helpers(std::move(translated), dialect);
    const Definitions definitions{translated, dialect};
    const std::set<std::string> declared = declared_names(modules);
    Statements opening;
    Statements values;     // declared constants and structs
    Statements bound;      // what the translator adds: blocks, globals, their structs
    Statements functions;  // helpers of the translator first
    Statements entry;      // and what it calls
    for (Statement& statement : translated) {
        const text::Definition definition = definition_of(statement, dialect);
        const bool function = definition.kind == DefinitionKind::function;
        const bool called_by_entry =
            function && !declared.contains(definition.name) && !is_helper(definition);
        if (is_entry_point(definition.name) || called_by_entry)
            entry.push_back(std::move(statement));
        else if (is_opening(statement))
            opening.push_back(std::move(statement));
        else if (!declared.contains(definition.name))
            (function ? functions : bound).push_back(std::move(statement));
    }
    for (const SourceModule& module : modules) {
        for (const Declaration& declaration : module.declarations) {
            if (is_entry_point(declaration.name)) continue;
            const bool function = declaration.kind == Declaration::Kind::function;
            append(function ? functions : values, definitions.find(declaration, false));
        }
    }
    if (!entry.empty() && !modules.empty())
        entry.back().above.insert(entry.back().above.begin(), modules.back().head.begin(),
                                  modules.back().head.end());
    for (Statements* part : {&values, &bound, &functions, &entry}) {
        if (!part->empty()) part->front().gap = !opening.empty();
        append(opening, *part);
    }
    return opening;
}

}  // namespace lacquer::codegen
