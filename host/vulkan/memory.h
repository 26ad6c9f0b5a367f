// Buffers and images on a device, and the way of the host's bytes into them and back. For source
// files only.
#pragma once

#include <cstddef>
#include <span>
#include <vulkan/vulkan_raii.hpp>

#include "core/buffer_argument.h"

namespace lacquer::vulkan {

// A buffer with its memory; mapped where the host can see it.
struct Buffer {
    vk::raii::Buffer handle = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
    std::byte* mapped = nullptr;
};

// A buffer that the host sees and the device uses as `usage` says. Throws Error where the device
// has no such memory.
Buffer create_host_buffer(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                          std::size_t size, vk::BufferUsageFlags usage);

// An image with its memory.
struct Image {
    vk::raii::Image handle = nullptr;
    vk::raii::DeviceMemory memory = nullptr;
};

// An image that the device alone sees. Throws Error where it has no memory for one.
Image create_device_image(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                          const vk::ImageCreateInfo& info);

// A buffer for one binding that grows as needed. Where host and device share memory the host uses
// it directly; otherwise bytes travel through a second buffer that the host sees.
class BindingBuffer {
 public:
    BindingBuffer(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                  BufferArgument::Kind kind);

    // Makes room for at least `size` bytes; what was in it is lost.
    void reserve(std::size_t size);

    void write(std::span<const std::byte> bytes);
    void read(std::span<std::byte> bytes) const;

    // Record the copies between the two buffers; nothing where they are one.
    void record_upload(const vk::raii::CommandBuffer& commands, std::size_t size) const;
    void record_download(const vk::raii::CommandBuffer& commands, std::size_t size) const;

    vk::Buffer handle() const { return *device_side_.handle; }
    BufferArgument::Kind kind() const { return kind_; }

 private:
    const vk::raii::PhysicalDevice* physical_;
    const vk::raii::Device* device_;
    BufferArgument::Kind kind_;
    bool shares_memory_;
    std::size_t capacity_ = 0;
    Buffer device_side_;
    Buffer host_side_;
};

}  // namespace lacquer::vulkan
