// What a module binds and where it starts.
#pragma once

#include "codegen/codegen.h"
#include "codegen/compile.h"

namespace lacquer::codegen {

struct Reflection {
    std::vector<EntryPoint> entry_points;
    std::vector<Binding> bindings;  // sorted by set and binding
};

Reflection reflect(const Words& words);

}  // namespace lacquer::codegen
