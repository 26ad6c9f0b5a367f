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

// The same the other way, for tests of what `translate_to_wgsl` gave.
struct NagaAnswer {
    Words words;
    std::string complaint;  // empty where naga accepts the text
};
std::vector<NagaAnswer> translate_from_wgsl(std::span<const std::string> texts);

}  // namespace lacquer::codegen
