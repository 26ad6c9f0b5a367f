// The Vulkan loader, an instance, and the devices it shows. For source files only: vulkan_raii.hpp
// takes seconds to read.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "vulkan/compute.h"
#include "vulkan/validation.h"

namespace lacquer::vulkan {

// An instance whose validation messages, where asked for, go to `log`.
struct Instance {
    vk::raii::Context context;
    vk::raii::Instance handle = nullptr;
    vk::raii::DebugUtilsMessengerEXT messenger = nullptr;
};

// Loads Vulkan 1.1 or newer with the drivers that `options` need and `extensions` besides. Throws
// Unavailable where the loader, every driver, an extension or the validation layer is missing.
Instance create_instance(const DeviceOptions& options, std::vector<const char*> extensions,
                         const std::shared_ptr<ValidationLog>& log);

// Why a device does not serve; nothing where it does.
using Refusal = std::function<std::optional<std::string>(const vk::raii::PhysicalDevice& device)>;

// The device that `wanted` (see DeviceOptions) names among those that serve. Throws Unavailable
// listing every device found, with the reasons of those refused.
vk::raii::PhysicalDevice choose_device(const vk::raii::Instance& instance,
                                       const std::string& wanted, const Refusal& refusal);

// The first queue family with all of `flags`.
std::optional<std::uint32_t> find_queue_family(const vk::raii::PhysicalDevice& device,
                                               vk::QueueFlags flags);

}  // namespace lacquer::vulkan
