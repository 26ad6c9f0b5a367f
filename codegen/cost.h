// What shaders cost, as far as it can be counted before a driver sees them.
#pragma once

#include <string>

#include "codegen/compile.h"
#include "codegen/variants.h"

namespace lacquer::codegen {

// SPIR-V instructions of `function`, with all that it calls inlined, after the optimisations of
// `spirv-opt -O`; what stands in a loop counts once. Throws Error where the module lacks it.
std::size_t optimised_instruction_count(const Words& words, const std::string& function);

// Texels that lq_LEVEL_prepare reads at most, counted by running it; 0 for levels without tables.
std::size_t table_reads(const Level& level);

}  // namespace lacquer::codegen
