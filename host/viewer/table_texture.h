// The packed tables as a texture for the shaders of the variant `sphere_view`. For source files
// only.
#pragma once

#include <vulkan/vulkan_raii.hpp>

#include "viewer/graphics_device.h"
#include "vulkan/memory.h"

namespace lacquer::viewer {

class TableTexture {
 public:
    // Uploads the file that `lacquer export` writes too. Throws Error where it is missing.
    explicit TableTexture(const GraphicsDevice& graphics);

    vk::ImageView view() const { return *view_; }

 private:
    vulkan::Image image_;
    vk::raii::ImageView view_ = nullptr;
};

}  // namespace lacquer::viewer
