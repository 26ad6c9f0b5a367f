#include "viewer/renderer.h"

#include <cstdint>
#include <limits>
#include <vulkan/vulkan_raii.hpp>

#include "viewer/graphics_device.h"
#include "viewer/sphere_pass.h"
#include "viewer/swapchain.h"
#include "vulkan/memory.h"

namespace lacquer::viewer {

namespace {

using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;
using Layout = vk::ImageLayout;

constexpr std::uint64_t kForever = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kBytesPerPixel = 4;

void record_layout_change(const vk::raii::CommandBuffer& commands, vk::Image image, Layout before,
                          Layout after, Stage stage_before, Stage stage_after,
                          vk::AccessFlags access_before, vk::AccessFlags access_after) {
    const vk::ImageSubresourceRange whole{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};
    const vk::ImageMemoryBarrier barrier{
        access_before,           access_after, before, after, VK_QUEUE_FAMILY_IGNORED,
        VK_QUEUE_FAMILY_IGNORED, image,        whole};
    commands.pipelineBarrier(stage_before, stage_after, {}, {}, {}, barrier);
}

// Copies a drawn image, which is then ready to be presented again.
void record_copy(const vk::raii::CommandBuffer& commands, vk::Image image, vk::Extent2D extent,
                 vk::Buffer destination) {
    record_layout_change(commands, image, Layout::ePresentSrcKHR, Layout::eTransferSrcOptimal,
                         Stage::eColorAttachmentOutput, Stage::eTransfer,
                         Access::eColorAttachmentWrite, Access::eTransferRead);
    const vk::ImageSubresourceLayers layers{vk::ImageAspectFlagBits::eColor, 0, 0, 1};
    const vk::BufferImageCopy region{0, 0, 0, layers, {}, {extent.width, extent.height, 1}};
    commands.copyImageToBuffer(image, Layout::eTransferSrcOptimal, destination, region);
    record_layout_change(commands, image, Layout::eTransferSrcOptimal, Layout::ePresentSrcKHR,
                         Stage::eTransfer, Stage::eBottomOfPipe, Access::eTransferRead, {});
    const vk::MemoryBarrier read{Access::eTransferWrite, Access::eHostRead};
    commands.pipelineBarrier(Stage::eTransfer, Stage::eHost, {}, read, {}, {});
}

Screenshot screenshot_of(const std::byte* bytes, vk::Extent2D extent, vk::Format format) {
    Screenshot screenshot{static_cast<int>(extent.width), static_cast<int>(extent.height), {}};
    const bool blue_first = format == vk::Format::eB8G8R8A8Unorm;
    const auto channel = [bytes](std::size_t index) {
        return static_cast<std::uint8_t>(bytes[index]);
    };
    const std::size_t count = std::size_t{extent.width} * extent.height;
    for (std::size_t pixel = 0; pixel < count; ++pixel) {
        const std::size_t first = pixel * kBytesPerPixel;
        screenshot.pixels.push_back({channel(first + (blue_first ? 2 : 0)), channel(first + 1),
                                     channel(first + (blue_first ? 0 : 2)), 255});
    }
    return screenshot;
}

}  // namespace

struct Renderer::Impl {
    const Window& window;
    GraphicsDevice graphics;
    std::string name;
    vk::SurfaceFormatKHR format;
    SpherePass sphere;
    vk::raii::CommandPool pool;
    vk::raii::CommandBuffer commands = nullptr;
    vk::raii::Semaphore acquired;
    vk::raii::Fence done;
    Swapchain swapchain;
    glm::uvec2 window_size{};  // that it was made for

    Impl(const Window& target, const vulkan::DeviceOptions& options);
    ~Impl() { graphics.device.waitIdle(); }

    void drop_swapchain();
    bool ensure_swapchain();
    bool draw(const Scene& scene, const vulkan::Buffer* copy);
    void record(const Scene& scene, const SwapchainImage& image, const vulkan::Buffer* copy);
    void submit_and_wait(vk::Semaphore drawn);
    bool present(std::uint32_t index, vk::Semaphore drawn);
};

Renderer::Impl::Impl(const Window& target, const vulkan::DeviceOptions& options)
    : window{target},
      graphics{options, target},
      name{graphics.physical.getProperties().deviceName.data()},
      format{choose_surface_format(graphics)},
      sphere{graphics, format.format},
      pool{graphics.device,
           vk::CommandPoolCreateInfo{vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                     graphics.queue_family}},
      acquired{graphics.device, vk::SemaphoreCreateInfo{}},
      done{graphics.device, vk::FenceCreateInfo{}} {
    const vk::CommandBufferAllocateInfo info{*pool, vk::CommandBufferLevel::ePrimary, 1};
    commands = std::move(vk::raii::CommandBuffers{graphics.device, info}[0]);
}

void Renderer::Impl::drop_swapchain() {
    graphics.device.waitIdle();  // presenting may still use it
    swapchain = {};
}

// Makes images of the window's size; false while it is minimised. Some drivers go on drawing to the
// old images after the window was resized, and do not say so.
bool Renderer::Impl::ensure_swapchain() {
    const glm::uvec2 size = window.size();
    if (size.x == 0 || size.y == 0) return false;
    if (!swapchain.images.empty() && size == window_size) return true;
    drop_swapchain();  // a window has one at a time
    swapchain = create_swapchain(graphics, format, sphere.render_pass(), size);
    window_size = size;
    return true;
}

bool Renderer::Impl::draw(const Scene& scene, const vulkan::Buffer* copy) {
    std::uint32_t index = 0;
    try {
        index = swapchain.handle.acquireNextImage(kForever, *acquired).second;
    } catch (const vk::OutOfDateKHRError&) {
        drop_swapchain();
        return false;
    }
    const SwapchainImage& image = swapchain.images[index];
    record(scene, image, copy);
    submit_and_wait(*image.drawn);
    const bool shown = present(index, *image.drawn);
    graphics.throw_messages();
    return shown;
}

void Renderer::Impl::record(const Scene& scene, const SwapchainImage& image,
                            const vulkan::Buffer* copy) {
    const vk::Extent2D extent = swapchain.extent;
    commands.reset();
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    sphere.record(commands, *image.framebuffer, extent,
                  sphere_view(scene, extent.width, extent.height), scene.model);
    if (copy != nullptr) record_copy(commands, image.image, extent, *copy->handle);
    commands.end();
}

// One frame at a time: a frame takes less than the display's interval, and input is never late.
void Renderer::Impl::submit_and_wait(vk::Semaphore drawn) {
    const vk::PipelineStageFlags stage = Stage::eColorAttachmentOutput;
    graphics.device.resetFences(*done);
    graphics.queue.submit(vk::SubmitInfo{*acquired, stage, *commands, drawn}, *done);
    while (graphics.device.waitForFences(*done, true, kForever) == vk::Result::eTimeout) {
    }
}

// False where the window has changed, and with it the images to draw to.
bool Renderer::Impl::present(std::uint32_t index, vk::Semaphore drawn) {
    try {
        const vk::Result result =
            graphics.queue.presentKHR(vk::PresentInfoKHR{drawn, *swapchain.handle, index});
        if (result == vk::Result::eSuccess) return true;
    } catch (const vk::OutOfDateKHRError&) {
    }
    drop_swapchain();
    return false;
}

Renderer::Renderer(const Window& window, const std::string& device, bool validation)
    : impl_{std::make_unique<Impl>(window, vulkan::DeviceOptions{device, validation})} {}

Renderer::~Renderer() = default;

bool Renderer::draw(const Scene& scene) {
    return impl_->ensure_swapchain() && impl_->draw(scene, nullptr);
}

std::optional<Screenshot> Renderer::capture(const Scene& scene) {
    if (!impl_->ensure_swapchain()) return std::nullopt;
    const vk::Extent2D extent = impl_->swapchain.extent;
    const vulkan::Buffer copy = vulkan::create_host_buffer(
        impl_->graphics.physical, impl_->graphics.device,
        kBytesPerPixel * extent.width * extent.height, vk::BufferUsageFlagBits::eTransferDst);
    if (!impl_->draw(scene, &copy)) return std::nullopt;
    return screenshot_of(copy.mapped, extent, impl_->format.format);
}

const std::string& Renderer::device_name() const {
    return impl_->name;
}

}  // namespace lacquer::viewer
