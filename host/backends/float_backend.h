// What the backends that run generated shaders share: packing, splitting and timing a job.
#pragma once

#include <array>
#include <set>
#include <utility>

#include "backends/backend.h"
#include "core/buffer_argument.h"

namespace lacquer {

// Most queries of one dispatch: their buffers stay within every interface's guaranteed limits
// (128 MiB per storage buffer, 65535 workgroups).
inline constexpr std::uint64_t kMaxDispatchQueries = std::uint64_t{1} << 20;

// Invocations per workgroup of every kernel (shader_src/kernels/bindings.glsl).
inline constexpr std::uint32_t kWorkgroupSize = 64;

// Part of a job that fits one dispatch, in the form every kernel takes.
struct Dispatch {
    Model model = Model::plain;
    Kernel kernel = Kernel::eval;
    std::span<const glm::vec4> surfaces;  // packed rows, see pack.h
    std::span<const glm::vec4> inputs;
    KernelParameters parameters;

    std::uint32_t workgroups() const;
};

// The buffers of a dispatch, by their bindings in shader_src/kernels/bindings.glsl.
std::array<BufferArgument, 5> kernel_arguments(const Dispatch& dispatch,
                                               std::span<glm::vec4> results);
std::vector<BufferArgument::Kind> kernel_argument_kinds();

class FloatBackend : public Backend {
 public:
    void prepare(Model model, Kernel kernel) final;
    JobResult run(const Job& job) final;

 protected:
    // Called once for each model and kernel, before execute().
    virtual void compile(Model model, Kernel kernel) = 0;

    // Runs one part and writes result_rows per query to `results`. Returns the seconds the kernel
    // took by the device's own clock, where it has one.
    virtual std::optional<double> execute(const Dispatch& dispatch,
                                          std::span<glm::vec4> results) = 0;

 private:
    std::set<std::pair<Model, Kernel>> prepared_;
};

}  // namespace lacquer
