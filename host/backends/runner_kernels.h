// Kernels in a runner's process, in whichever language it takes.
#pragma once

#include <memory>
#include <string>

#include "backends/float_backend.h"
#include "backends/runner_process.h"

namespace lacquer {

class RunnerKernels : public FloatBackend {
 public:
    // Runs the generated kernels in the language `target`, named as in the manifest.
    RunnerKernels(std::unique_ptr<RunnerProcess> process, std::string target);

    std::string device() const override { return process_->adapter(); }

 protected:
    void compile(Model model, Kernel kernel) override;

    RunnerProcess& process() { return *process_; }

 private:
    std::optional<double> execute(const Dispatch& dispatch, std::span<glm::vec4> results) final;

    std::unique_ptr<RunnerProcess> process_;
    std::string target_;
};

}  // namespace lacquer
