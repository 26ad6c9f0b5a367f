#include "viewer/table_texture.h"

#include <cstring>
#include <string>

#include "core/file.h"
#include "core/paths.h"
#include "tables/texels.h"

namespace lacquer::viewer {

namespace {

using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;
using Layout = vk::ImageLayout;

constexpr const char* kFile = "shaders/tables/lacquer_tables.rgba32ui";
constexpr vk::Format kFormat = vk::Format::eR32G32B32A32Uint;
constexpr std::size_t kBytesPerTexel = 16;

constexpr vk::ImageSubresourceRange kWhole{vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1};

vk::Extent3D extent_of(const std::string& bytes) {
    const std::size_t rows = bytes.size() / (kBytesPerTexel * kTexelColumns);
    return {static_cast<std::uint32_t>(kTexelColumns), static_cast<std::uint32_t>(rows), 1};
}

void record_barrier(const vk::raii::CommandBuffer& commands, vk::Image image, Layout before,
                    Layout after, Stage stage_before, Stage stage_after,
                    vk::AccessFlags access_before, vk::AccessFlags access_after) {
    const vk::ImageMemoryBarrier barrier{
        access_before,           access_after, before, after, VK_QUEUE_FAMILY_IGNORED,
        VK_QUEUE_FAMILY_IGNORED, image,        kWhole};
    commands.pipelineBarrier(stage_before, stage_after, {}, {}, {}, barrier);
}

void record_upload(const vk::raii::CommandBuffer& commands, vk::Buffer bytes, vk::Image image,
                   vk::Extent3D extent) {
    record_barrier(commands, image, Layout::eUndefined, Layout::eTransferDstOptimal,
                   Stage::eTopOfPipe, Stage::eTransfer, {}, Access::eTransferWrite);
    const vk::ImageSubresourceLayers layers{vk::ImageAspectFlagBits::eColor, 0, 0, 1};
    commands.copyBufferToImage(bytes, image, Layout::eTransferDstOptimal,
                               vk::BufferImageCopy{0, 0, 0, layers, {}, extent});
    record_barrier(commands, image, Layout::eTransferDstOptimal, Layout::eShaderReadOnlyOptimal,
                   Stage::eTransfer, Stage::eFragmentShader, Access::eTransferWrite,
                   Access::eShaderRead);
}

// Fills `image`, and returns once that is done.
void upload(const GraphicsDevice& graphics, const std::string& bytes, vk::Image image) {
    const vulkan::Buffer staging = vulkan::create_host_buffer(
        graphics.physical, graphics.device, bytes.size(), vk::BufferUsageFlagBits::eTransferSrc);
    std::memcpy(staging.mapped, bytes.data(), bytes.size());
    const vk::raii::CommandPool pool{graphics.device,
                                     vk::CommandPoolCreateInfo{{}, graphics.queue_family}};
    const vk::CommandBufferAllocateInfo info{*pool, vk::CommandBufferLevel::ePrimary, 1};
    const vk::raii::CommandBuffer commands =
        std::move(vk::raii::CommandBuffers{graphics.device, info}[0]);
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    record_upload(commands, *staging.handle, image, extent_of(bytes));
    commands.end();
    graphics.queue.submit(vk::SubmitInfo{{}, {}, *commands});
    graphics.queue.waitIdle();
}

}  // namespace

TableTexture::TableTexture(const GraphicsDevice& graphics) {
    const std::string bytes = read_file(share_file(kFile));
    vk::ImageCreateInfo info;
    info.setImageType(vk::ImageType::e2D)
        .setFormat(kFormat)
        .setExtent(extent_of(bytes))
        .setMipLevels(1)
        .setArrayLayers(1)
        .setUsage(vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst);
    image_ = vulkan::create_device_image(graphics.physical, graphics.device, info);
    upload(graphics, bytes, *image_.handle);
    view_ = {graphics.device, vk::ImageViewCreateInfo{
                                  {}, *image_.handle, vk::ImageViewType::e2D, kFormat, {}, kWhole}};
}

}  // namespace lacquer::viewer
