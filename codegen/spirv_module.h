// A SPIR-V module as a list of instructions, for small rewrites.
#pragma once

#include <glslang/SPIRV/spirv.hpp>
#include <string>
#include <vector>

#include "codegen/compile.h"

namespace lacquer::codegen {

struct Instruction {
    spv::Op op = spv::OpNop;
    Words operands;          // result type and result id included
    std::uint32_t type = 0;  // ids; 0 where there is none
    std::uint32_t result = 0;
    std::vector<std::size_t>
        id_positions;  // operands that are ids used, not defined, and not types
};

struct SpirvModule {
    Words header;  // five words
    std::vector<Instruction> instructions;

    explicit SpirvModule(const Words& words);
    Words words() const;

    // An id that nothing uses yet.
    std::uint32_t fresh_id() { return header[3]++; }
};

// The text that begins at operand `first`.
std::string literal_string(const Instruction& instruction, std::size_t first);

// `text` as operands.
Words string_literal(const std::string& text);

// Whether the module has a function of that name.
bool defines_function(const SpirvModule& module, std::string_view name);

// Instructions within functions, counted once however often they run; those of entry points only
// where they are part of what is counted.
std::size_t instruction_count(const SpirvModule& module, bool entry_points);

}  // namespace lacquer::codegen
