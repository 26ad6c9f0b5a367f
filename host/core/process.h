// Other programs, run to their end.
#pragma once

#include <filesystem>
#include <optional>
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

// The program of that name on the PATH; nothing where there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

// Wine for 64-bit programs, which Debian keeps off the PATH; nothing where there is none.
std::optional<std::filesystem::path> find_wine();

}  // namespace lacquer
