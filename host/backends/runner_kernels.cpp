#include "backends/runner_kernels.h"

#include <fmt/format.h>

#include "backends/shader_store.h"
#include "core/error.h"

namespace lacquer {

namespace {

std::string name_of(Model model, Kernel kernel) {
    return fmt::format("{}_{}", model_name(model), kernel_shape(kernel).name);
}

}  // namespace

RunnerKernels::RunnerKernels(std::unique_ptr<RunnerProcess> process, std::string target)
    : process_{std::move(process)}, target_{std::move(target)} {}

void RunnerKernels::compile(Model model, Kernel kernel) {
    const ShaderSource source = load_shader(target_, model, kernel);
    try {
        process_->compile(name_of(model, kernel), source.contents, source.entry_point,
                          kernel_argument_kinds());
    } catch (const Error& error) {
        throw Error{fmt::format("'{}': {}", source.file.string(), error.what())};
    }
}

std::optional<double> RunnerKernels::execute(const Dispatch& dispatch,
                                             std::span<glm::vec4> results) {
    process_->run(name_of(dispatch.model, dispatch.kernel), kernel_arguments(dispatch, results),
                  dispatch.workgroups());
    return std::nullopt;
}

}  // namespace lacquer
