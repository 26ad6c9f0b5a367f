// Draws the sphere with the generated SPIR-V of the variant `sphere_view`. For source files only.
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include "viewer/graphics_device.h"
#include "viewer/scene.h"
#include "vulkan/memory.h"

namespace lacquer::viewer {

class SpherePass {
 public:
    // Draws to images of `format`, which are left ready to be presented.
    SpherePass(const GraphicsDevice& graphics, vk::Format format);

    vk::RenderPass render_pass() const { return *render_pass_; }

    // Records the drawing of `view` over the whole of `framebuffer`. What was recorded before must
    // have been executed.
    void record(const vk::raii::CommandBuffer& commands, vk::Framebuffer framebuffer,
                vk::Extent2D extent, const SphereView& view);

 private:
    void create_render_pass(const vk::raii::Device& device, vk::Format format);
    void create_descriptors(const vk::raii::Device& device);
    void create_pipeline(const vk::raii::Device& device);

    vulkan::BindingBuffer view_;
    vk::raii::RenderPass render_pass_ = nullptr;
    vk::raii::DescriptorSetLayout set_layout_ = nullptr;
    vk::raii::DescriptorPool pool_ = nullptr;
    vk::raii::DescriptorSet set_ = nullptr;
    vk::raii::PipelineLayout layout_ = nullptr;
    vk::raii::Pipeline pipeline_ = nullptr;
};

}  // namespace lacquer::viewer
