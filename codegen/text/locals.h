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

// Gives locals that the translator named (`_123`, `_e12`, kSelectedName) the name `result` where
// they are returned at once, otherwise that of their type in snake_case, `selected` or `value`.
void name_locals(Statement& function, Dialect dialect);

// Drops the copies that glslang makes of values in order to index them, where the value stays as
// it is for as long as the copy is used.
void drop_copies(Statement& function, Dialect dialect);

// Puts the value of nameless variables (`_123`) that only constants make up where they are used.
void inline_constants(Statement& function, Dialect dialect);

// Gives locals named after a built-in (`gl_VertexIndex_1`) a name of their own: `vertex_index`.
void name_built_ins(Statement& function, Dialect dialect);

// `else { if ... }` to `else if ...`.
void join_else_if(Statements& statements);

}  // namespace lacquer::codegen::text
