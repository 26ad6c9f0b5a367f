#include "viewer/sphere_pass.h"

#include <fmt/format.h>

#include <array>
#include <cstring>
#include <vector>

#include "core/file.h"
#include "core/paths.h"

namespace lacquer::viewer {

namespace {

using Stage = vk::PipelineStageFlagBits;
using Access = vk::AccessFlagBits;

constexpr vk::ShaderStageFlags kShaders =
    vk::ShaderStageFlagBits::eVertex | vk::ShaderStageFlagBits::eFragment;
constexpr std::uint32_t kTriangle = 3;  // vertices

vk::raii::ShaderModule load_shader(const vk::raii::Device& device, std::string_view level,
                                   std::string_view stage) {
    const std::string bytes = read_file(
        share_file(fmt::format("shaders/spirv/kernel/{}_sphere_view.{}.spv", level, stage)));
    std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
    std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
    return {device, vk::ShaderModuleCreateInfo{{}, words}};
}

}  // namespace

SpherePass::SpherePass(const GraphicsDevice& graphics, vk::Format format)
    : device_{&graphics.device},
      view_{graphics.physical, graphics.device, BufferArgument::Kind::uniform},
      tables_{graphics} {
    view_.reserve(sizeof(SphereView));
    create_render_pass(graphics.device, format);
    create_descriptors(graphics.device);
    layout_ = {graphics.device, vk::PipelineLayoutCreateInfo{{}, *set_layout_}};
}

void SpherePass::create_render_pass(const vk::raii::Device& device, vk::Format format) {
    vk::AttachmentDescription color;
    color.setFormat(format)
        .setLoadOp(vk::AttachmentLoadOp::eDontCare)  // the triangle covers everything
        .setStoreOp(vk::AttachmentStoreOp::eStore)
        .setStencilLoadOp(vk::AttachmentLoadOp::eDontCare)
        .setStencilStoreOp(vk::AttachmentStoreOp::eDontCare)
        .setFinalLayout(vk::ImageLayout::ePresentSrcKHR);
    const vk::AttachmentReference reference{0, vk::ImageLayout::eColorAttachmentOptimal};
    vk::SubpassDescription subpass;
    subpass.setColorAttachments(reference);
    // The image is drawn to once it has been acquired, which this stage waits for.
    const vk::SubpassDependency acquired{
        VK_SUBPASS_EXTERNAL,           0,  Stage::eColorAttachmentOutput,
        Stage::eColorAttachmentOutput, {}, Access::eColorAttachmentWrite};
    render_pass_ = {device, vk::RenderPassCreateInfo{{}, color, subpass, acquired}};
}

void SpherePass::create_descriptors(const vk::raii::Device& device) {
    using Type = vk::DescriptorType;
    const std::array bindings{vk::DescriptorSetLayoutBinding{0, Type::eUniformBuffer, 1, kShaders},
                              vk::DescriptorSetLayoutBinding{1, Type::eSampledImage, 1,
                                                             vk::ShaderStageFlagBits::eFragment}};
    set_layout_ = {device, vk::DescriptorSetLayoutCreateInfo{{}, bindings}};
    const std::array sizes{vk::DescriptorPoolSize{Type::eUniformBuffer, 1},
                           vk::DescriptorPoolSize{Type::eSampledImage, 1}};
    pool_ = {device, vk::DescriptorPoolCreateInfo{
                         vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes}};
    set_ = std::move(
        vk::raii::DescriptorSets{device, vk::DescriptorSetAllocateInfo{*pool_, *set_layout_}}[0]);
    const vk::DescriptorBufferInfo buffer{view_.handle(), 0, sizeof(SphereView)};
    const vk::DescriptorImageInfo texture{
        {}, tables_.view(), vk::ImageLayout::eShaderReadOnlyOptimal};
    device.updateDescriptorSets(
        {vk::WriteDescriptorSet{*set_, 0, 0, Type::eUniformBuffer, {}, buffer},
         vk::WriteDescriptorSet{*set_, 1, 0, Type::eSampledImage, texture}},
        {});
}

vk::raii::Pipeline SpherePass::create_pipeline(const vk::raii::Device& device,
                                               std::string_view level) const {
    const vk::raii::ShaderModule vertex = load_shader(device, level, "vert");
    const vk::raii::ShaderModule fragment = load_shader(device, level, "frag");
    const std::array stages{
        vk::PipelineShaderStageCreateInfo{{}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"},
        vk::PipelineShaderStageCreateInfo{
            {}, vk::ShaderStageFlagBits::eFragment, *fragment, "main"}};
    const vk::PipelineVertexInputStateCreateInfo no_vertices;
    const vk::PipelineInputAssemblyStateCreateInfo assembly{{},
                                                            vk::PrimitiveTopology::eTriangleList};
    const vk::PipelineViewportStateCreateInfo viewport{{}, 1, nullptr, 1, nullptr};
    vk::PipelineRasterizationStateCreateInfo rasterization;
    rasterization.setLineWidth(1.0f);
    const vk::PipelineMultisampleStateCreateInfo multisample;
    vk::PipelineColorBlendAttachmentState opaque;
    opaque.setColorWriteMask(vk::FlagTraits<vk::ColorComponentFlagBits>::allFlags);
    vk::PipelineColorBlendStateCreateInfo blend;
    blend.setAttachments(opaque);
    const std::array dynamic_states{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
    const vk::PipelineDynamicStateCreateInfo dynamic{{}, dynamic_states};
    const vk::GraphicsPipelineCreateInfo info{
        {},           stages,  &no_vertices, &assembly, nullptr,  &viewport,     &rasterization,
        &multisample, nullptr, &blend,       &dynamic,  *layout_, *render_pass_, 0};
    return {device, nullptr, info};
}

vk::Pipeline SpherePass::pipeline_of(Model model) {
    const std::string_view level = model_level(model);
    auto found = pipelines_.find(level);
    if (found == pipelines_.end())
        found = pipelines_.emplace(level, create_pipeline(*device_, level)).first;
    return *found->second;
}

void SpherePass::record(const vk::raii::CommandBuffer& commands, vk::Framebuffer framebuffer,
                        vk::Extent2D extent, const SphereView& view, Model model) {
    view_.write(std::as_bytes(std::span{&view, 1}));
    view_.record_upload(commands, sizeof(SphereView));
    const vk::MemoryBarrier uploaded{Access::eTransferWrite, Access::eUniformRead};
    commands.pipelineBarrier(Stage::eTransfer, Stage::eVertexShader | Stage::eFragmentShader, {},
                             uploaded, {}, {});
    const vk::Rect2D whole{{0, 0}, extent};
    const vk::Viewport viewport{
        0.0f, 0.0f, static_cast<float>(extent.width), static_cast<float>(extent.height),
        0.0f, 1.0f};
    commands.beginRenderPass(vk::RenderPassBeginInfo{*render_pass_, framebuffer, whole},
                             vk::SubpassContents::eInline);
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, pipeline_of(model));
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_, 0, *set_, {});
    commands.setViewport(0, viewport);
    commands.setScissor(0, whole);
    commands.draw(kTriangle, 1, 0, 0);
    commands.endRenderPass();
}

}  // namespace lacquer::viewer
