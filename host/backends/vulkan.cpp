// Backend `vulkan`: the generated SPIR-V.
#include <fmt/format.h>

#include <cstring>

#include "backends/entries.h"
#include "backends/shader_store.h"
#include "backends/vulkan_kernels.h"
#include "core/error.h"

namespace lacquer {

namespace {

class VulkanBackend final : public VulkanKernels {
 public:
    using VulkanKernels::VulkanKernels;

 private:
    Module module_of(Model model, Kernel kernel) const override {
        const ShaderSource source = load_shader("spirv", model, kernel);
        if (source.contents.size() % sizeof(std::uint32_t) != 0)
            throw Error{fmt::format("'{}' is no SPIR-V: {} bytes are not whole words",
                                    source.file.string(), source.contents.size())};
        std::vector<std::uint32_t> words(source.contents.size() / sizeof(std::uint32_t));
        std::memcpy(words.data(), source.contents.data(), source.contents.size());
        return {std::move(words), source.entry_point};
    }
};

}  // namespace

constinit const BackendEntry kVulkanEntry{
    "vulkan", "SPIR-V on Vulkan",
    [](const BackendOptions& options) {
        return probe_by_trying([&] { return vulkan_device_name(options); });
    },
    [](const BackendOptions& options) -> std::unique_ptr<Backend> {
        return std::make_unique<VulkanBackend>(options);
    }};

}  // namespace lacquer
