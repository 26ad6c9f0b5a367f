// Rewrites of a SPIR-V module after which translators write readable text. None changes what is
// computed.
#pragma once

#include "codegen/spirv_module.h"

namespace lacquer::codegen {

// Cuts glslang's parameter lists off function names: "f(vf3;" is "f". naga would spell them out.
void cut_signatures(SpirvModule& module);

// Marks whole buffers as read-only whose members are. naga reads the mark there only.
void mark_read_only_buffers(SpirvModule& module);

// Turns specialization constants into ordinary ones that keep their names, and computes what is
// made of them where it is used, because naga takes nothing but scalars.
void release_constants(SpirvModule& module);

// Moves constants of struct type into the functions that use them; HLSL would get a nameless
// global for each.
void inline_struct_constants(SpirvModule& module);

// The name of nameless variables that glslang makes for `c ? a : b`; the text is rid of most again.
inline constexpr const char* kSelectedName = "lq_selected";

// Gives it to them.
void name_temporaries(SpirvModule& module);

}  // namespace lacquer::codegen
