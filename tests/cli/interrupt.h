// Ctrl-C in the middle of a command.
#pragma once

#include "cli/run_lacquer.h"

namespace lacquer::test {

// Runs `lacquer` with these arguments and interrupts it as soon as it handles interrupts.
ProcessResult interrupt_lacquer(const Words& arguments);

}  // namespace lacquer::test
