// Tidies expressions without changing what they compute.
#pragma once

#include "codegen/text/tree.h"

namespace lacquer::codegen::text {

// Removes parentheses that change nothing about how an expression is read: those whose operators
// bind as tightly without. Shifts and bit operators keep theirs.
void remove_parentheses(Tokens& tokens);

// `text`, a decimal float literal, as the shortest decimal that reads back as the same float, with
// a digit on either side of the point. Other literals are returned as they are.
std::string shortest_float(const std::string& text);

// `vec3(x, x, x)` as `vec3(x)` where x is a number or a constant's name.
void join_splats(Tokens& tokens);

// `vec2(u.y, u.z)` and `vec2(u.yz)` as `u.yz`.
void join_components(Tokens& tokens);

// Rewrites every float literal with `shortest_float`; a suffix stays.
void shorten_numbers(Tokens& tokens);

}  // namespace lacquer::codegen::text
