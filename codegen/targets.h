// The languages that codegen writes.
#pragma once

#include "codegen/codegen.h"

namespace lacquer::codegen {

struct TargetEntry {
    Target target;
    std::string_view name;         // on the command line and in paths
    std::string_view extension;    // of its files, without the dot
    std::string_view description;  // in file heads and help texts
};

const TargetEntry& target_entry(Target target);

}  // namespace lacquer::codegen
