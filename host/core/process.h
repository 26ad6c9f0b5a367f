// Other programs, run to their end.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace lacquer {

struct ProcessResult {
    int exit_code = 0;
    std::string out;
    std::string err;
};

// Runs `program` with `arguments`, `input` on its standard input, until it ends. Throws Error where
// the program cannot be started.
ProcessResult run_process(const std::filesystem::path& program,
                          const std::vector<std::string>& arguments, const std::string& input = {});

}  // namespace lacquer
