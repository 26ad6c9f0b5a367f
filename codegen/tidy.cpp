// What all languages of the C family are tidied by.
#include <vector>

#include "codegen/emit.h"
#include "codegen/names.h"
#include "codegen/text/expressions.h"
#include "codegen/text/locals.h"

namespace lacquer::codegen {

text::Dialect dialect_of(Target target) {
    switch (target) {
        case Target::hlsl50:
        case Target::hlsl60:
            return text::Dialect::hlsl;
        case Target::msl:
            return text::Dialect::msl;
        case Target::wgsl:
            return text::Dialect::wgsl;
        default:
            return text::Dialect::glsl;
    }
}

void name_tables(text::Statements& statements, text::Dialect dialect) {
    char letter = 'a';
    for (const text::Statement& statement : text::Statements{statements}) {
        const text::Definition definition = definition_of(statement, dialect);
        const bool nameless =
            definition.kind == text::DefinitionKind::constant && definition.name.starts_with('_');
        if (!nameless) continue;
        rename(statements, definition.name, std::string{kTableName} + letter);
        if (letter < 'z') ++letter;
    }
}

void tidy_c_family(text::Statements& statements, text::Dialect dialect) {
    name_tables(statements, dialect);
    std::vector<std::string> names;
    for (const text::Statement& statement : statements)
        names.push_back(definition_of(statement, dialect).name);
    for (text::Statement& statement : statements) {
        if (definition_of(statement, dialect).kind != text::DefinitionKind::function) continue;
        text::restore_choices(statement);
        text::drop_copies(statement, dialect);
        text::inline_constants(statement, dialect);
        text::name_locals(statement, dialect);
        text::restore_names(statement, dialect, names);
    }
    text::for_each_tokens(statements, text::shorten_numbers);
    text::for_each_tokens(statements, text::remove_parentheses);
    text::for_each_tokens(statements, text::join_components);
    // HLSL has no vectors from one scalar.
    if (dialect != text::Dialect::hlsl) text::for_each_tokens(statements, text::join_splats);
    text::join_else_if(statements);
}

}  // namespace lacquer::codegen
