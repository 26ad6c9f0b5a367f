#include "codegen/spirv_module.h"

#include <algorithm>
#include <cstring>
#include <set>
#include <spirv-tools/libspirv.hpp>

#include "core/error.h"

namespace lacquer::codegen {

namespace {

constexpr std::size_t kHeaderWords = 5;

bool is_used_id(spv_operand_type_t type) {
    return type == SPV_OPERAND_TYPE_ID || type == SPV_OPERAND_TYPE_MEMORY_SEMANTICS_ID ||
           type == SPV_OPERAND_TYPE_SCOPE_ID;
}

spv_result_t take_instruction(void* module, const spv_parsed_instruction_t* parsed) {
    Instruction instruction;
    instruction.op = static_cast<spv::Op>(parsed->opcode);
    instruction.type = parsed->type_id;
    instruction.result = parsed->result_id;
    instruction.operands.assign(parsed->words + 1, parsed->words + parsed->num_words);
    for (std::uint16_t i = 0; i < parsed->num_operands; ++i)
        if (is_used_id(parsed->operands[i].type))
            instruction.id_positions.push_back(parsed->operands[i].offset - 1u);
    static_cast<SpirvModule*>(module)->instructions.push_back(std::move(instruction));
    return SPV_SUCCESS;
}

}  // namespace

SpirvModule::SpirvModule(const Words& words) {
    if (words.size() < kHeaderWords) throw Error{"SPIR-V of fewer than five words"};
    header.assign(words.begin(), words.begin() + kHeaderWords);
    const spvtools::Context context{SPV_ENV_VULKAN_1_1};
    if (spvBinaryParse(context.CContext(), this, words.data(), words.size(), nullptr,
                       take_instruction, nullptr) != SPV_SUCCESS)
        throw Error{"SPIR-V that SPIRV-Tools cannot read"};
}

Words SpirvModule::words() const {
    Words words = header;
    for (const Instruction& instruction : instructions) {
        const auto length = static_cast<std::uint32_t>(instruction.operands.size() + 1);
        words.push_back(length << spv::WordCountShift | instruction.op);
        words.insert(words.end(), instruction.operands.begin(), instruction.operands.end());
    }
    return words;
}

std::string literal_string(const Instruction& instruction, std::size_t first) {
    const auto* bytes = reinterpret_cast<const char*>(instruction.operands.data() + first);
    return {bytes, strnlen(bytes, (instruction.operands.size() - first) * sizeof(std::uint32_t))};
}

Words string_literal(const std::string& text) {
    Words words(text.size() / sizeof(std::uint32_t) + 1, 0u);
    std::memcpy(words.data(), text.data(), text.size());
    return words;
}

bool defines_function(const SpirvModule& module, std::string_view name) {
    return std::ranges::any_of(module.instructions, [&](const Instruction& instruction) {
        return instruction.op == spv::OpName && literal_string(instruction, 1) == name;
    });
}

std::size_t instruction_count(const SpirvModule& module, bool entry_points) {
    std::set<std::uint32_t> entries;
    std::size_t count = 0;
    bool counting = false;
    for (const Instruction& instruction : module.instructions) {
        if (instruction.op == spv::OpEntryPoint) entries.insert(instruction.operands[1]);
        if (instruction.op == spv::OpFunction)
            counting = entry_points || !entries.contains(instruction.result);
        count += counting ? 1 : 0;
        if (instruction.op == spv::OpFunctionEnd) counting = false;
    }
    return count;
}

}  // namespace lacquer::codegen
