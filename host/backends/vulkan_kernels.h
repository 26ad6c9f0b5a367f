// SPIR-V kernels on a Vulkan device, wherever the SPIR-V comes from.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "backends/float_backend.h"
#include "vulkan/compute.h"

namespace lacquer {

class VulkanKernels : public FloatBackend {
 public:
    explicit VulkanKernels(const BackendOptions& options);

    std::string device() const override { return device_.name(); }

 protected:
    struct Module {
        std::vector<std::uint32_t> spirv;
        std::string entry_point;
    };

    virtual Module module_of(Model model, Kernel kernel) const = 0;

 private:
    void compile(Model model, Kernel kernel) final;
    std::optional<double> execute(const Dispatch& dispatch, std::span<glm::vec4> results) final;

    vulkan::Device device_;
    std::map<std::pair<Model, Kernel>, vulkan::Kernel> kernels_;
};

// The name of the Vulkan device that `options` choose. Throws Unavailable where there is none.
std::string vulkan_device_name(const BackendOptions& options);

}  // namespace lacquer
