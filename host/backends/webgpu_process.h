// A process that runs WGSL: host/backends/webgpu/runner.mjs in Deno or Node, kept alive between
// dispatches.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/buffer_argument.h"
#include "core/environment.h"

namespace lacquer {

// What starts the runner.
struct WebgpuProgram {
    std::filesystem::path program;
    std::vector<std::string> arguments;
};

// The runner's process. Everything throws Error with WebGPU's message, or with the last words of
// the process where it ended. One thread at a time.
class WebgpuProcess {
 public:
    // Starts the runner in the environment as it is now.
    explicit WebgpuProcess(const WebgpuProgram& program);
    ~WebgpuProcess();
    WebgpuProcess(const WebgpuProcess&) = delete;
    WebgpuProcess& operator=(const WebgpuProcess&) = delete;

    const std::string& adapter() const;

    // Compiles `source` under the name `kernel`.
    void compile(const std::string& kernel, const std::string& source,
                 const std::string& entry_point, std::span<const BufferArgument::Kind> kinds);

    // Runs a compiled kernel; the results go where the last argument says.
    void run(const std::string& kernel, std::span<const BufferArgument> arguments,
             std::uint32_t groups);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace lacquer
