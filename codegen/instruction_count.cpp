// Counts instructions after optimisation.
#include <fmt/format.h>

#include <algorithm>
#include <spirv-tools/optimizer.hpp>

#include "codegen/cost.h"
#include "codegen/spirv_module.h"
#include "core/error.h"

namespace lacquer::codegen {

namespace {

std::uint32_t find_function(const SpirvModule& module, const std::string& name) {
    for (const Instruction& instruction : module.instructions) {
        if (instruction.op == spv::OpEntryPoint && literal_string(instruction, 2) == name)
            return instruction.operands[1];
        if (instruction.op == spv::OpName && literal_string(instruction, 1) == name)
            return instruction.operands[0];
    }
    throw Error{fmt::format("counting instructions: the module has no function '{}'", name)};
}

// Else it would vanish into its caller.
void keep_apart(SpirvModule& module, std::uint32_t function) {
    for (Instruction& instruction : module.instructions)
        if (instruction.op == spv::OpFunction && instruction.result == function)
            instruction.operands[2] |= spv::FunctionControlDontInlineMask;
}

std::size_t length_of(const SpirvModule& module, std::uint32_t function) {
    const auto begin = std::ranges::find_if(module.instructions, [&](const Instruction& i) {
        return i.op == spv::OpFunction && i.result == function;
    });
    const auto end = std::find_if(begin, module.instructions.end(),
                                  [](const Instruction& i) { return i.op == spv::OpFunctionEnd; });
    if (end == module.instructions.end()) throw Error{"counting instructions: a function is lost"};
    return static_cast<std::size_t>(end - begin) + 1;
}

}  // namespace

std::size_t optimised_instruction_count(const Words& words, const std::string& function) {
    SpirvModule module{words};
    const std::uint32_t id = find_function(module, function);
    keep_apart(module, id);
    spvtools::Optimizer optimizer{SPV_ENV_VULKAN_1_1};
    optimizer.RegisterPerformancePasses();
    const Words marked = module.words();
    Words optimised;
    if (!optimizer.Run(marked.data(), marked.size(), &optimised))
        throw Error{fmt::format("counting instructions of '{}': SPIRV-Tools refuses", function)};
    return length_of(SpirvModule{optimised}, id);
}

}  // namespace lacquer::codegen
