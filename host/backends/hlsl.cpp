// Backend `hlsl`: the generated HLSL of shader model 5.0, through glslang to Vulkan.
#include "backends/entries.h"
#include "backends/hlsl_to_spirv.h"
#include "backends/shader_store.h"
#include "backends/vulkan_kernels.h"

namespace lacquer {

namespace {

class HlslBackend final : public VulkanKernels {
 public:
    using VulkanKernels::VulkanKernels;

 private:
    Module module_of(Model model, Kernel kernel) const override {
        const ShaderSource source = load_shader("hlsl50", model, kernel);
        return {hlsl_to_spirv(source.contents, source.entry_point, source.file.string()),
                source.entry_point};
    }
};

}  // namespace

constinit const BackendEntry kHlslEntry{
    "hlsl", "HLSL 5.0 through glslang on Vulkan",
    [](const BackendOptions& options) {
        return probe_by_trying([&] { return vulkan_device_name(options); });
    },
    [](const BackendOptions& options) -> std::unique_ptr<Backend> {
        return std::make_unique<HlslBackend>(options);
    }};

}  // namespace lacquer
