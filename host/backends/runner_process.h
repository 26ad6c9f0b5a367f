// A process that compiles and runs kernels where this one cannot: host/backends/webgpu/runner.mjs
// in Deno or Node, host/backends/fxc in Wine. It is kept alive between dispatches. Messages are
// described in host/backends/webgpu/messages.mjs.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/buffer_argument.h"

namespace lacquer {

// What starts the runner.
struct RunnerProgram {
    std::filesystem::path program;
    std::vector<std::string> arguments;
};

// The runner's process. Everything throws Error with the runner's message, or with the last words
// of the process where it ended. One thread at a time.
class RunnerProcess {
 public:
    // Starts the runner in the environment as it is now.
    explicit RunnerProcess(const RunnerProgram& program);
    ~RunnerProcess();
    RunnerProcess(const RunnerProcess&) = delete;
    RunnerProcess& operator=(const RunnerProcess&) = delete;

    // What executes, in the runner's words.
    const std::string& adapter() const;

    // Compiles `source` under the name `kernel`.
    void compile(const std::string& kernel, const std::string& source,
                 const std::string& entry_point, std::span<const BufferArgument::Kind> kinds);

    // Compiles `source` with the second compiler of a runner that has two, and throws the result
    // away.
    void check(const std::string& source, const std::string& entry_point);

    // Runs a compiled kernel; the results go where the last argument says.
    void run(const std::string& kernel, std::span<const BufferArgument> arguments,
             std::uint32_t groups);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lacquer
