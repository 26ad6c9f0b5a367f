// Tidies the WGSL that naga writes: it names every load, declares every variable at the top of its
// function and writes every loop as `loop`. Each step below works on one function.
#pragma once

#include <map>
#include <set>
#include <string>

#include "codegen/text/tree.h"

namespace lacquer::codegen::text {

// Names of variables of the module, which a called function may read or write.
using ModuleVariables = std::set<std::string>;

// Puts the value of `let _e12 = value;` where it is used, unless something that it reads is
// written in between.
void inline_lets(Statement& function, const ModuleVariables& variables);

// Lets the variable that receives a choice (kSelectedName) take its place.
void merge_choices(Statement& function);

// Moves each `var` to where its variable is first set, as `let` where it is never set again.
void place_variables(Statement& function);

// Writes `loop` with a condition as `while`, with a `continuing` besides as `for`.
void restore_loops(Statement& function);

// `x = x + y` as `x += y`.
void restore_compound_assignments(Statement& function);

// Types of variables by name, and of members by "Struct.member".
using Types = std::map<std::string, std::string>;

// Types of the module's variables, of all struct members, and of what functions return.
Types module_types(const Statements& statements);

// Those and the types of a function's parameters and variables, as naga declares them.
Types function_types(const Statement& function, const Types& module);

// `v[2u]` as `v.z` where v is a vector, and `bitcast<u32>` of an integer as `u32`.
void restore_swizzles(Statement& function, const Types& types);

// `vec4f(v.x, v.y, v.z, a)` as `vec4f(v, a)` where v is a vector of three.
void join_vectors(Statement& function, const Types& types);

// naga's entry point copies its parameters to globals, calls a function of its own and returns what
// that left in other globals. Where no other function reads those, the function's body moves into
// the entry point and the globals become its variables.
void join_entry_point(Statements& statements);

// `1f` as `1.0`, `2i` as `2`; `vec3f(0.0, 0.0, 0.0)` as `vec3f(0.0)`.
void restore_literals(Tokens& tokens);

// `if x {` as `if (x) {`.
void parenthesize_conditions(Statement& function);

}  // namespace lacquer::codegen::text
