// SPIR-V to the statements of each language family, tidied; one source file per family.
#pragma once

#include <string>

#include "codegen/codegen.h"
#include "codegen/compile.h"
#include "codegen/text/tree.h"

namespace lacquer::codegen {

// The family that a text target belongs to.
text::Dialect dialect_of(Target target);

// GLSL 4.50, ESSL 3.10, ESSL 3.00.
text::Statements emit_glsl(const Words& words, Target target);

// HLSL for shader model 5.0 or 6.0; binding N is register N.
text::Statements emit_hlsl(const Words& words, Target target);

// Metal Shading Language 2.2; binding N is index N.
text::Statements emit_msl(const Words& words);

// The name that "main", reserved in C++, has in MSL.
inline constexpr const char* kMslEntryPoint = "main0";

// WGSL from what naga made of the module.
text::Statements emit_wgsl(const std::string& naga_text);

// Constants that have no name in the source, such as the values of a local table, get this and a
// letter.
inline constexpr const char* kTableName = "lq_values_";
void name_tables(text::Statements& statements, text::Dialect dialect);

// What all languages of the C family are tidied by: numbers, parentheses, choices, names.
void tidy_c_family(text::Statements& statements, text::Dialect dialect);

}  // namespace lacquer::codegen
