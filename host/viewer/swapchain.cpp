#include "viewer/swapchain.h"

#include <algorithm>
#include <limits>

#include "core/error.h"

namespace lacquer::viewer {

namespace {

using Usage = vk::ImageUsageFlagBits;

// One image to draw to while another is shown.
constexpr std::uint32_t kWantedImages = 2;

vk::Extent2D choose_extent(const vk::SurfaceCapabilitiesKHR& surface, glm::uvec2 size) {
    // A surface that leaves the size to the swapchain says so with this number.
    if (surface.currentExtent.width != std::numeric_limits<std::uint32_t>::max())
        return surface.currentExtent;
    return {std::clamp(size.x, surface.minImageExtent.width, surface.maxImageExtent.width),
            std::clamp(size.y, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

std::uint32_t choose_image_count(const vk::SurfaceCapabilitiesKHR& surface) {
    const std::uint32_t count = std::max(kWantedImages, surface.minImageCount);
    return surface.maxImageCount == 0 ? count : std::min(count, surface.maxImageCount);
}

vk::CompositeAlphaFlagBitsKHR choose_alpha(const vk::SurfaceCapabilitiesKHR& surface) {
    using Alpha = vk::CompositeAlphaFlagBitsKHR;
    return surface.supportedCompositeAlpha & Alpha::eOpaque ? Alpha::eOpaque : Alpha::eInherit;
}

vk::raii::SwapchainKHR create_handle(const GraphicsDevice& graphics, vk::SurfaceFormatKHR format,
                                     const vk::SurfaceCapabilitiesKHR& surface,
                                     vk::Extent2D extent) {
    vk::SwapchainCreateInfoKHR info;
    info.setSurface(*graphics.surface)
        .setMinImageCount(choose_image_count(surface))
        .setImageFormat(format.format)
        .setImageColorSpace(format.colorSpace)
        .setImageExtent(extent)
        .setImageArrayLayers(1)
        .setImageUsage(Usage::eColorAttachment | Usage::eTransferSrc)
        .setPreTransform(surface.currentTransform)
        .setCompositeAlpha(choose_alpha(surface))
        .setPresentMode(vk::PresentModeKHR::eFifo)  // always there
        .setClipped(false);                         // hidden pixels are part of a screenshot
    return {graphics.device, info};
}

SwapchainImage create_image(const vk::raii::Device& device, vk::Image image, vk::Format format,
                            vk::RenderPass render_pass, vk::Extent2D extent) {
    const vk::ImageSubresourceRange whole{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};
    vk::raii::ImageView view{
        device, vk::ImageViewCreateInfo{{}, image, vk::ImageViewType::e2D, format, {}, whole}};
    vk::raii::Framebuffer framebuffer{
        device, vk::FramebufferCreateInfo{{}, render_pass, *view, extent.width, extent.height, 1}};
    return {image, std::move(view), std::move(framebuffer),
            vk::raii::Semaphore{device, vk::SemaphoreCreateInfo{}}};
}

}  // namespace

vk::SurfaceFormatKHR choose_surface_format(const GraphicsDevice& graphics) {
    const auto formats = graphics.physical.getSurfaceFormatsKHR(*graphics.surface);
    for (const vk::Format wanted : {vk::Format::eB8G8R8A8Unorm, vk::Format::eR8G8B8A8Unorm})
        for (const vk::SurfaceFormatKHR& format : formats)
            if (format.format == wanted) return format;
    throw Unavailable{"this window's pixels are not of 8 bits per channel",
                      "choose another device with --device"};
}

Swapchain create_swapchain(const GraphicsDevice& graphics, vk::SurfaceFormatKHR format,
                           vk::RenderPass render_pass, glm::uvec2 size) {
    const auto surface = graphics.physical.getSurfaceCapabilitiesKHR(*graphics.surface);
    if (!(surface.supportedUsageFlags & Usage::eTransferSrc))
        throw Unavailable{"this window's pixels cannot be read", "choose another device"};
    Swapchain swapchain;
    swapchain.extent = choose_extent(surface, size);
    swapchain.handle = create_handle(graphics, format, surface, swapchain.extent);
    for (const VkImage image : swapchain.handle.getImages())
        swapchain.images.push_back(
            create_image(graphics.device, image, format.format, render_pass, swapchain.extent));
    return swapchain;
}

}  // namespace lacquer::viewer
