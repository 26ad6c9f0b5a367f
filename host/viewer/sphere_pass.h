// Draws the sphere with the generated SPIR-V of the variant `sphere_view`. For source files only.
#pragma once

#include <map>
#include <string_view>
#include <vulkan/vulkan_raii.hpp>

#include "core/model.h"
#include "viewer/graphics_device.h"
#include "viewer/scene.h"
#include "viewer/table_texture.h"
#include "vulkan/memory.h"

namespace lacquer::viewer {

class SpherePass {
 public:
    // Draws to images of `format`, which are left ready to be presented. `graphics` stays the
    // caller's and must outlive it.
    SpherePass(const GraphicsDevice& graphics, vk::Format format);

    vk::RenderPass render_pass() const { return *render_pass_; }

    // Records the drawing of `view`, shaded by `model`, over the whole of `framebuffer`. What was
    // recorded before must have been executed.
    void record(const vk::raii::CommandBuffer& commands, vk::Framebuffer framebuffer,
                vk::Extent2D extent, const SphereView& view, Model model);

 private:
    void create_render_pass(const vk::raii::Device& device, vk::Format format);
    void create_descriptors(const vk::raii::Device& device);
    vk::raii::Pipeline create_pipeline(const vk::raii::Device& device,
                                       std::string_view level) const;

    // That of the level of `model`, made when it is first asked for.
    vk::Pipeline pipeline_of(Model model);

    const vk::raii::Device* device_;
    vulkan::BindingBuffer view_;
    TableTexture tables_;
    vk::raii::RenderPass render_pass_ = nullptr;
    vk::raii::DescriptorSetLayout set_layout_ = nullptr;
    vk::raii::DescriptorPool pool_ = nullptr;
    vk::raii::DescriptorSet set_ = nullptr;
    vk::raii::PipelineLayout layout_ = nullptr;
    std::map<std::string_view, vk::raii::Pipeline> pipelines_;  // by level
};

}  // namespace lacquer::viewer
