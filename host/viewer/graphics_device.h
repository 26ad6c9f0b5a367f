// A Vulkan device that can draw to a window. For source files only: vulkan_raii.hpp takes seconds
// to read.
#pragma once

#include <cstdint>
#include <memory>
#include <vulkan/vulkan_raii.hpp>

#include "viewer/window.h"
#include "vulkan/compute.h"
#include "vulkan/instance.h"
#include "vulkan/validation.h"

namespace lacquer::viewer {

// Members in the order in which they stand on each other.
struct GraphicsDevice {
    std::shared_ptr<vulkan::ValidationLog> log = std::make_shared<vulkan::ValidationLog>();
    vulkan::Instance instance;
    vk::raii::SurfaceKHR surface = nullptr;
    vk::raii::PhysicalDevice physical = nullptr;
    std::uint32_t queue_family = 0;  // draws and presents
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;

    // Throws Unavailable where no device that `options` allow can draw to `window`.
    GraphicsDevice(const vulkan::DeviceOptions& options, const Window& window);

    // Throws Error where the validation layers have said something.
    void throw_messages() const;
};

}  // namespace lacquer::viewer
