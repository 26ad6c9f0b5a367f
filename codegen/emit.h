// SPIR-V to the text of each language family; one source file per family.
#pragma once

#include <string>

#include "codegen/codegen.h"
#include "codegen/compile.h"

namespace lacquer::codegen {

// GLSL 4.50, ESSL 3.10, ESSL 3.00.
std::string emit_glsl(const Words& words, Target target);

// HLSL for shader model 5.0 or 6.0; binding N is register N.
std::string emit_hlsl(const Words& words, Target target);

// Metal Shading Language 2.2; binding N is index N.
std::string emit_msl(const Words& words);

// The name that "main", reserved in C++, has in MSL.
inline constexpr const char* kMslEntryPoint = "main0";

}  // namespace lacquer::codegen
