// The library form: functions without an entry point.
#pragma once

#include <string>
#include <vector>

#include "codegen/codegen.h"
#include "codegen/declarations.h"
#include "codegen/text/tree.h"
#include "codegen/variants.h"

namespace lacquer::codegen {

// The stage that library entries are compiled for: the one that every language has.
inline constexpr Stage kLibraryStage = Stage::fragment;

// What whoever uses functions that read tables supplies.
inline constexpr std::string_view kTableAccess = "lq_table_texel";
inline constexpr std::string_view kLayerAccess = "lq_stack_row";

// GLSL that calls every function of `modules`, the last of which is `source`: compilers drop what
// no entry point reaches.
std::string library_entry(const std::string& source, const std::vector<SourceModule>& modules);

// The same with a call of the function `name` alone; empty where no module declares it.
std::string function_entry(const std::string& source, const std::vector<SourceModule>& modules,
                           const std::string& name);

// The public functions that `statements` define, with the first sentences of their documentation.
std::vector<Function> public_functions(const text::Statements& statements,
                                       const std::vector<SourceModule>& modules,
                                       text::Dialect dialect);

}  // namespace lacquer::codegen
