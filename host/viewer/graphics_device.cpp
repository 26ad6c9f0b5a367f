#include "viewer/graphics_device.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>

#include "core/error.h"

namespace lacquer::viewer {

namespace {

bool has_swapchains(const vk::raii::PhysicalDevice& device) {
    return std::ranges::any_of(
        device.enumerateDeviceExtensionProperties(), [](const vk::ExtensionProperties& extension) {
            return std::string_view{extension.extensionName} == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
        });
}

std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device,
                                               vk::SurfaceKHR surface) {
    const auto families = device.getQueueFamilyProperties();
    for (std::uint32_t index = 0; index < families.size(); ++index)
        if ((families[index].queueFlags & vk::QueueFlagBits::eGraphics) &&
            device.getSurfaceSupportKHR(index, surface))
            return index;
    return std::nullopt;
}

std::optional<std::string> refuse(const vk::raii::PhysicalDevice& device, vk::SurfaceKHR surface) {
    if (device.getProperties().apiVersion < VK_API_VERSION_1_1) return "older than Vulkan 1.1";
    if (!has_swapchains(device)) return "cannot present";
    if (!find_queue_family(device, surface)) return "cannot draw to this display";
    return std::nullopt;
}

}  // namespace

GraphicsDevice::GraphicsDevice(const vulkan::DeviceOptions& options, const Window& window)
    : instance{vulkan::create_instance(options, window.vulkan_extensions(), log)} {
    surface = {instance.handle, window.create_surface(*instance.handle)};
    physical = vulkan::choose_device(
        instance.handle, options.device,
        [this](const vk::raii::PhysicalDevice& candidate) { return refuse(candidate, *surface); });
    queue_family = find_queue_family(physical, *surface).value();
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue_info{{}, queue_family, 1, &priority};
    const char* swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
    device = {physical, vk::DeviceCreateInfo{{}, queue_info, {}, swapchain}};
    queue = {device, queue_family, 0};
}

void GraphicsDevice::throw_messages() const {
    if (const auto messages = log->take(); !messages.empty())
        throw Error{fmt::format("Vulkan validation: {}", fmt::join(messages, "\n"))};
}

}  // namespace lacquer::viewer
