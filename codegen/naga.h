// naga, the WGSL translator and validator, run in Node.js.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "codegen/codegen.h"
#include "codegen/compile.h"

namespace lacquer::codegen {

struct NagaJob {
    std::string name;  // for messages
    Words words;
};

// WGSL for each module, in one process. Throws Error with naga's message where it refuses one.
std::vector<std::string> translate_to_wgsl(std::span<const NagaJob> jobs);

// naga's complaints about WGSL texts, in one process; empty where there are none.
std::vector<std::string> check_wgsl(std::span<const std::string> texts);

}  // namespace lacquer::codegen
