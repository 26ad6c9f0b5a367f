// GLSL to SPIR-V for Vulkan 1.1.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "codegen/source_tree.h"
#include "codegen/variants.h"

namespace lacquer::codegen {

using Words = std::vector<std::uint32_t>;

struct CompileOptions {
    Stage stage = Stage::compute;
    std::string preamble;  // whole lines that stand before the source; see level_preamble
    // Keep the names of global constants, which are otherwise folded into their uses: they become
    // specialization constants, and names.h makes ordinary ones of them again. For text only.
    bool named_constants = false;
};

// Compiles `text`, which goes by the name `file` in the tree, and what it includes. Branches and
// functions that are never reached are left out. Throws Error with the compiler's messages, file
// and line first.
Words compile(const SourceTree& tree, const std::string& file, const std::string& text,
              const CompileOptions& options);

// Throws Error where `words` break the rules of SPIR-V for Vulkan 1.1.
void validate(const Words& words, const std::string& file);

}  // namespace lacquer::codegen
