#include "backends/vulkan_kernels.h"

namespace lacquer {

VulkanKernels::VulkanKernels(const BackendOptions& options)
    : device_{vulkan::DeviceOptions{options.device, options.validation}} {}

void VulkanKernels::compile(Model model, Kernel kernel) {
    const Module module = module_of(model, kernel);
    kernels_.emplace(std::pair{model, kernel},
                     device_.compile(module.spirv, module.entry_point, kernel_argument_kinds()));
}

std::optional<double> VulkanKernels::execute(const Dispatch& dispatch,
                                             std::span<glm::vec4> results) {
    return device_.run(kernels_.at({dispatch.model, dispatch.kernel}),
                       kernel_arguments(dispatch, results), dispatch.workgroups());
}

std::string vulkan_device_name(const BackendOptions& options) {
    return vulkan::Device{{options.device, options.validation}}.name();
}

}  // namespace lacquer
