#include "vulkan/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "core/error.h"

namespace lacquer::vulkan {

namespace {

using Property = vk::MemoryPropertyFlagBits;

constexpr vk::MemoryPropertyFlags kHost = Property::eHostVisible | Property::eHostCoherent;

// In the order of preference: reading uncached memory is ten times slower.
constexpr std::array kHostMemory{kHost | Property::eHostCached, kHost};
constexpr std::array kDeviceMemory{vk::MemoryPropertyFlags{Property::eDeviceLocal},
                                   vk::MemoryPropertyFlags{}};

// Small buffers are not worth growing one by one.
constexpr std::size_t kSmallestCapacity = 256;

bool shares_memory_with_host(const vk::raii::PhysicalDevice& device) {
    const vk::PhysicalDeviceType type = device.getProperties().deviceType;
    return type == vk::PhysicalDeviceType::eCpu || type == vk::PhysicalDeviceType::eIntegratedGpu;
}

vk::BufferUsageFlags usage_of(BufferArgument::Kind kind) {
    return kind == BufferArgument::Kind::uniform ? vk::BufferUsageFlagBits::eUniformBuffer
                                                 : vk::BufferUsageFlagBits::eStorageBuffer;
}

std::optional<std::uint32_t> find_memory_type(const vk::PhysicalDeviceMemoryProperties& memory,
                                              std::uint32_t allowed,
                                              vk::MemoryPropertyFlags wanted) {
    for (std::uint32_t index = 0; index < memory.memoryTypeCount; ++index)
        if ((allowed >> index & 1u) && (memory.memoryTypes[index].propertyFlags & wanted) == wanted)
            return index;
    return std::nullopt;
}

// Memory of the first of `preferences` that there is; `what` names its use in messages.
struct Allocation {
    vk::raii::DeviceMemory memory;
    vk::MemoryPropertyFlags flags;
};

Allocation allocate(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                    const vk::MemoryRequirements& needed,
                    std::span<const vk::MemoryPropertyFlags> preferences, std::string_view what) {
    const auto memory = physical.getMemoryProperties();
    for (const vk::MemoryPropertyFlags flags : preferences)
        if (const auto type = find_memory_type(memory, needed.memoryTypeBits, flags))
            return {{device, vk::MemoryAllocateInfo{needed.size, *type}}, flags};
    throw Error{fmt::format("Vulkan: no memory type for {} of {} bytes", what, needed.size)};
}

Buffer create_buffer(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                     std::size_t size, vk::BufferUsageFlags usage,
                     std::span<const vk::MemoryPropertyFlags> preferences) {
    Buffer buffer;
    buffer.handle = {device, vk::BufferCreateInfo{{}, size, usage}};
    Allocation allocation =
        allocate(physical, device, buffer.handle.getMemoryRequirements(), preferences, "a buffer");
    buffer.memory = std::move(allocation.memory);
    buffer.handle.bindMemory(*buffer.memory, 0);
    if (allocation.flags & Property::eHostVisible)
        buffer.mapped = static_cast<std::byte*>(buffer.memory.mapMemory(0, VK_WHOLE_SIZE));
    return buffer;
}

}  // namespace

Buffer create_host_buffer(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                          std::size_t size, vk::BufferUsageFlags usage) {
    return create_buffer(physical, device, size, usage, kHostMemory);
}

Image create_device_image(const vk::raii::PhysicalDevice& physical, const vk::raii::Device& device,
                          const vk::ImageCreateInfo& info) {
    Image image{{device, info}};
    image.memory =
        allocate(physical, device, image.handle.getMemoryRequirements(), kDeviceMemory, "an image")
            .memory;
    image.handle.bindMemory(*image.memory, 0);
    return image;
}

BindingBuffer::BindingBuffer(const vk::raii::PhysicalDevice& physical,
                             const vk::raii::Device& device, BufferArgument::Kind kind)
    : physical_{&physical},
      device_{&device},
      kind_{kind},
      shares_memory_{shares_memory_with_host(physical)} {}

void BindingBuffer::reserve(std::size_t size) {
    if (size <= capacity_) return;
    const std::size_t capacity = std::bit_ceil(std::max(size, kSmallestCapacity));
    device_side_ = {};  // before its successor, or both would need memory at once
    host_side_ = {};
    capacity_ = 0;
    using Usage = vk::BufferUsageFlagBits;
    if (shares_memory_) {
        device_side_ = create_buffer(*physical_, *device_, capacity, usage_of(kind_), kHostMemory);
    } else {
        const bool results = kind_ == BufferArgument::Kind::write;
        const auto away = results ? Usage::eTransferSrc : Usage::eTransferDst;
        const auto host = results ? Usage::eTransferDst : Usage::eTransferSrc;
        device_side_ =
            create_buffer(*physical_, *device_, capacity, usage_of(kind_) | away, kDeviceMemory);
        host_side_ = create_buffer(*physical_, *device_, capacity, host, kHostMemory);
    }
    capacity_ = capacity;
}

void BindingBuffer::write(std::span<const std::byte> bytes) {
    std::memcpy(shares_memory_ ? device_side_.mapped : host_side_.mapped, bytes.data(),
                bytes.size());
}

void BindingBuffer::read(std::span<std::byte> bytes) const {
    std::memcpy(bytes.data(), shares_memory_ ? device_side_.mapped : host_side_.mapped,
                bytes.size());
}

void BindingBuffer::record_upload(const vk::raii::CommandBuffer& commands, std::size_t size) const {
    if (shares_memory_) return;
    commands.copyBuffer(*host_side_.handle, *device_side_.handle, vk::BufferCopy{0, 0, size});
}

void BindingBuffer::record_download(const vk::raii::CommandBuffer& commands,
                                    std::size_t size) const {
    if (shares_memory_) return;
    commands.copyBuffer(*device_side_.handle, *host_side_.handle, vk::BufferCopy{0, 0, size});
}

}  // namespace lacquer::vulkan
