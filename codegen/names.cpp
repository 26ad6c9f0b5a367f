#include "codegen/names.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

namespace lacquer::codegen {

namespace {

using Id = std::uint32_t;

bool is_debug_or_decoration(spv::Op op) {
    return op == spv::OpName || op == spv::OpMemberName || op == spv::OpDecorate ||
           op == spv::OpMemberDecorate;
}

// Replaces uses, within functions, of each constant that `is_moved` chooses by an instruction that
// computes it just before; then drops the constants that nothing uses any more.
void move_into_functions(SpirvModule& module,
                         const std::function<bool(const Instruction&)>& is_moved) {
    std::map<Id, Instruction> moved;
    for (const Instruction& instruction : module.instructions)
        if (is_moved(instruction)) moved.emplace(instruction.result, instruction);

    std::vector<Instruction> rewritten;
    // Appends the computation of `id` and returns the id of its result.
    const std::function<Id(Id)> compute = [&](Id id) {
        const auto found = moved.find(id);
        if (found == moved.end()) return id;
        Instruction computed = found->second;
        for (const std::size_t position : computed.id_positions)
            computed.operands[position] = compute(computed.operands[position]);
        if (computed.op == spv::OpSpecConstantOp) {
            computed.op = static_cast<spv::Op>(computed.operands[2]);
            computed.operands.erase(computed.operands.begin() + 2);
            for (std::size_t& position : computed.id_positions) --position;
        } else {
            computed.op = spv::OpCompositeConstruct;
        }
        computed.result = computed.operands[1] = module.fresh_id();
        rewritten.push_back(computed);
        return computed.result;
    };
    bool inside = false;
    for (Instruction& instruction : module.instructions) {
        inside = inside || instruction.op == spv::OpFunction;
        if (inside && instruction.op != spv::OpVariable && instruction.op != spv::OpPhi)
            for (const std::size_t position : instruction.id_positions)
                instruction.operands[position] = compute(instruction.operands[position]);
        if (instruction.op == spv::OpFunctionEnd) inside = false;
        rewritten.push_back(instruction);
    }
    // Last first: what was used by a dropped constant may drop too.
    std::set<Id> used;
    std::vector<Instruction> kept;
    for (auto instruction = rewritten.rbegin(); instruction != rewritten.rend(); ++instruction) {
        if (moved.contains(instruction->result) && !used.contains(instruction->result)) continue;
        if (!is_debug_or_decoration(instruction->op))
            for (const std::size_t position : instruction->id_positions)
                used.insert(instruction->operands[position]);
        kept.push_back(*instruction);
    }
    std::ranges::reverse(kept);
    module.instructions = std::move(kept);
}

}  // namespace

void cut_signatures(SpirvModule& module) {
    for (Instruction& instruction : module.instructions) {
        if (instruction.op != spv::OpName) continue;
        const std::string name = literal_string(instruction, 1);
        const std::size_t end = name.find('(');
        if (end == std::string::npos) continue;
        const Words shorter = string_literal(name.substr(0, end));
        instruction.operands.resize(1);
        instruction.operands.insert(instruction.operands.end(), shorter.begin(), shorter.end());
    }
}

void mark_read_only_buffers(SpirvModule& module) {
    const auto is_member_mark = [](const Instruction& instruction) {
        return instruction.op == spv::OpMemberDecorate &&
               instruction.operands[2] == spv::DecorationNonWritable;
    };
    std::set<Id> read_only;
    std::map<Id, Id> pointed_at;
    for (const Instruction& instruction : module.instructions) {
        if (is_member_mark(instruction)) read_only.insert(instruction.operands[0]);
        if (instruction.op == spv::OpTypePointer)
            pointed_at[instruction.result] = instruction.operands[2];
    }
    std::vector<Instruction> marks;
    for (const Instruction& instruction : module.instructions)
        if (instruction.op == spv::OpVariable && read_only.contains(pointed_at[instruction.type]))
            marks.push_back({.op = spv::OpDecorate,
                             .operands = {instruction.result, spv::DecorationNonWritable},
                             .id_positions = {0}});
    if (marks.empty()) return;
    std::erase_if(module.instructions, is_member_mark);
    const auto place = std::ranges::find(module.instructions, spv::OpDecorate, &Instruction::op);
    module.instructions.insert(place, marks.begin(), marks.end());
}

void release_constants(SpirvModule& module) {
    std::erase_if(module.instructions, [](const Instruction& instruction) {
        return instruction.op == spv::OpDecorate &&
               instruction.operands[1] == spv::DecorationSpecId;
    });
    move_into_functions(module, [](const Instruction& instruction) {
        return instruction.op == spv::OpSpecConstantComposite ||
               instruction.op == spv::OpSpecConstantOp;
    });
}

void inline_struct_constants(SpirvModule& module) {
    std::set<Id> structs;
    for (const Instruction& instruction : module.instructions)
        if (instruction.op == spv::OpTypeStruct) structs.insert(instruction.result);
    move_into_functions(module, [&](const Instruction& instruction) {
        return instruction.op == spv::OpConstantComposite && structs.contains(instruction.type);
    });
}

void name_temporaries(SpirvModule& module) {
    std::set<Id> named;
    std::vector<Instruction> names;
    for (const Instruction& instruction : module.instructions) {
        if (instruction.op == spv::OpName && !literal_string(instruction, 1).empty())
            named.insert(instruction.operands[0]);
        if (instruction.op != spv::OpVariable || named.contains(instruction.result)) continue;
        if (instruction.operands[2] != spv::StorageClassFunction) continue;
        Instruction name{.op = spv::OpName, .operands = {instruction.result}, .id_positions = {0}};
        const Words literal = string_literal(kSelectedName);
        name.operands.insert(name.operands.end(), literal.begin(), literal.end());
        names.push_back(name);
    }
    const auto place = std::ranges::find(module.instructions, spv::OpName, &Instruction::op);
    module.instructions.insert(place, names.begin(), names.end());
}

}  // namespace lacquer::codegen
