// The images of a window, and what is drawn to them through. For source files only.
#pragma once

#include <glm/vec2.hpp>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "viewer/graphics_device.h"

namespace lacquer::viewer {

struct SwapchainImage {
    vk::Image image;
    vk::raii::ImageView view = nullptr;
    vk::raii::Framebuffer framebuffer = nullptr;
    vk::raii::Semaphore drawn = nullptr;  // presenting waits for it
};

struct Swapchain {
    vk::Extent2D extent;
    vk::raii::SwapchainKHR handle = nullptr;
    std::vector<SwapchainImage> images;
};

// Four channels of 8 bits that hold display colours as they are written; the shaders encode them.
// Throws Unavailable where the window has none.
vk::SurfaceFormatKHR choose_surface_format(const GraphicsDevice& graphics);

// Images of `size` pixels, where the window leaves a choice; they can be copied from.
Swapchain create_swapchain(const GraphicsDevice& graphics, vk::SurfaceFormatKHR format,
                           vk::RenderPass render_pass, glm::uvec2 size);

}  // namespace lacquer::viewer
