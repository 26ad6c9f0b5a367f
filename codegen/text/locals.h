// Tidies the local variables that translators leave behind.
#pragma once

#include "codegen/text/tree.h"

namespace lacquer::codegen::text {

// Writes `x = c ? a : b` again where the translator made a choice of two assignments to one of the
// variables that names.h calls kSelectedName. Languages of the C family only.
void restore_choices(Statement& function);

// Renames `x_1`, made where two scopes of a function use one name, to `x` where no `x` is in sight.
// `reserved` are the names of the whole file.
void restore_names(Statement& function, Dialect dialect, const std::vector<std::string>& reserved);

// Gives nameless locals (`_123`) the name of their type in snake_case, or `result` where they are
// returned at once.
void name_locals(Statement& function, Dialect dialect);

// `else { if ... }` to `else if ...`.
void join_else_if(Statements& statements);

}  // namespace lacquer::codegen::text
