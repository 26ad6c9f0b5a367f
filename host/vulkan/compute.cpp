#include "vulkan/compute.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.h"
#include "vulkan/instance.h"
#include "vulkan/memory.h"

namespace lacquer::vulkan {

namespace {

constexpr std::uint32_t kTimestampCount = 2;  // before and after the dispatch

std::optional<std::string> refuse(const vk::raii::PhysicalDevice& device) {
    if (device.getProperties().apiVersion < VK_API_VERSION_1_1) return "older than Vulkan 1.1";
    if (!find_queue_family(device, vk::QueueFlagBits::eCompute)) return "cannot compute";
    return std::nullopt;
}

vk::DescriptorType descriptor_type(BufferArgument::Kind kind) {
    return kind == BufferArgument::Kind::uniform ? vk::DescriptorType::eUniformBuffer
                                                 : vk::DescriptorType::eStorageBuffer;
}

// Orders everything recorded so far before everything to come.
void record_barrier(const vk::raii::CommandBuffer& commands, vk::PipelineStageFlags before,
                    vk::AccessFlags written, vk::PipelineStageFlags after, vk::AccessFlags read) {
    commands.pipelineBarrier(before, after, {}, vk::MemoryBarrier{written, read}, {}, {});
}

}  // namespace

struct Device::Impl {
    std::shared_ptr<ValidationLog> log = std::make_shared<ValidationLog>();
    Instance instance;
    vk::raii::PhysicalDevice physical = nullptr;
    std::string name;
    std::uint32_t queue_family = 0;
    vk::raii::Device device = nullptr;
    vk::raii::Queue queue = nullptr;
    vk::raii::CommandPool pool = nullptr;
    vk::raii::CommandBuffer commands = nullptr;
    vk::raii::Fence done = nullptr;
    vk::raii::QueryPool timestamps = nullptr;
    double seconds_per_tick = 0.0;       // 0: the device has no clock
    std::vector<BindingBuffer> buffers;  // one per binding

    explicit Impl(const DeviceOptions& options);
    void create_timestamps();
    void throw_messages() const;
    void upload(std::span<const BufferArgument> arguments);
    void bind(const Kernel::Impl& kernel, std::span<const BufferArgument> arguments) const;
    void record(const Kernel::Impl& kernel, std::span<const BufferArgument> arguments,
                std::uint32_t groups) const;
    void submit() const;
    std::optional<double> measured_seconds() const;
};

struct Kernel::Impl {
    vk::raii::DescriptorSetLayout set_layout = nullptr;
    vk::raii::PipelineLayout layout = nullptr;
    vk::raii::Pipeline pipeline = nullptr;
    vk::raii::DescriptorPool pool = nullptr;
    vk::raii::DescriptorSet set = nullptr;

    Impl(const vk::raii::Device& device, std::span<const std::uint32_t> spirv,
         const std::string& entry_point, const std::vector<BufferArgument::Kind>& kinds);
    void create_layout(const vk::raii::Device& device,
                       const std::vector<BufferArgument::Kind>& kinds);
};

Device::Impl::Impl(const DeviceOptions& options) : instance{create_instance(options, {}, log)} {
    physical = choose_device(instance.handle, options.device, refuse);
    name = physical.getProperties().deviceName.data();
    queue_family = *find_queue_family(physical, vk::QueueFlagBits::eCompute);
    const float priority = 1.0f;
    const vk::DeviceQueueCreateInfo queue_info{{}, queue_family, 1, &priority};
    device = {physical, vk::DeviceCreateInfo{{}, queue_info}};
    queue = {device, queue_family, 0};
    pool = {device, vk::CommandPoolCreateInfo{vk::CommandPoolCreateFlagBits::eResetCommandBuffer,
                                              queue_family}};
    commands = std::move(vk::raii::CommandBuffers{
        device, vk::CommandBufferAllocateInfo{*pool, vk::CommandBufferLevel::ePrimary, 1}}[0]);
    done = {device, vk::FenceCreateInfo{}};
    create_timestamps();
    throw_messages();
}

void Device::Impl::create_timestamps() {
    if (physical.getQueueFamilyProperties()[queue_family].timestampValidBits == 0) return;
    timestamps = {device, vk::QueryPoolCreateInfo{{}, vk::QueryType::eTimestamp, kTimestampCount}};
    seconds_per_tick = 1e-9 * static_cast<double>(physical.getProperties().limits.timestampPeriod);
}

void Device::Impl::throw_messages() const {
    if (const auto messages = log->take(); !messages.empty())
        throw Error{fmt::format("Vulkan validation: {}", fmt::join(messages, "\n"))};
}

void Device::Impl::upload(std::span<const BufferArgument> arguments) {
    for (std::size_t binding = 0; binding < arguments.size(); ++binding) {
        const BufferArgument& argument = arguments[binding];
        if (binding == buffers.size()) buffers.emplace_back(physical, device, argument.kind);
        if (buffers[binding].kind() != argument.kind)
            buffers[binding] = {physical, device, argument.kind};
        buffers[binding].reserve(argument.size());
        if (argument.kind != BufferArgument::Kind::write) buffers[binding].write(argument.bytes);
    }
}

void Device::Impl::bind(const Kernel::Impl& kernel,
                        std::span<const BufferArgument> arguments) const {
    std::vector<vk::DescriptorBufferInfo> infos;
    for (std::size_t binding = 0; binding < arguments.size(); ++binding)
        infos.emplace_back(buffers[binding].handle(), 0, arguments[binding].size());
    std::vector<vk::WriteDescriptorSet> writes;
    for (std::uint32_t binding = 0; binding < arguments.size(); ++binding)
        writes.emplace_back(*kernel.set, binding, 0, 1, descriptor_type(arguments[binding].kind),
                            nullptr, &infos[binding]);
    device.updateDescriptorSets(writes, {});
}

void Device::Impl::record(const Kernel::Impl& kernel, std::span<const BufferArgument> arguments,
                          std::uint32_t groups) const {
    using Stage = vk::PipelineStageFlagBits;
    using Access = vk::AccessFlagBits;
    commands.reset();
    commands.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    for (std::size_t binding = 0; binding < arguments.size(); ++binding)
        if (arguments[binding].kind != BufferArgument::Kind::write)
            buffers[binding].record_upload(commands, arguments[binding].size());
    record_barrier(commands, Stage::eTransfer, Access::eTransferWrite, Stage::eComputeShader,
                   Access::eShaderRead | Access::eUniformRead);

    commands.bindPipeline(vk::PipelineBindPoint::eCompute, *kernel.pipeline);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *kernel.layout, 0, *kernel.set,
                                {});
    if (seconds_per_tick > 0.0) {
        commands.resetQueryPool(*timestamps, 0, kTimestampCount);
        commands.writeTimestamp(Stage::eTopOfPipe, *timestamps, 0);
    }
    commands.dispatch(groups, 1, 1);
    if (seconds_per_tick > 0.0) commands.writeTimestamp(Stage::eComputeShader, *timestamps, 1);

    record_barrier(commands, Stage::eComputeShader, Access::eShaderWrite,
                   Stage::eTransfer | Stage::eHost, Access::eTransferRead | Access::eHostRead);
    for (std::size_t binding = 0; binding < arguments.size(); ++binding)
        if (arguments[binding].kind == BufferArgument::Kind::write)
            buffers[binding].record_download(commands, arguments[binding].size());
    record_barrier(commands, Stage::eTransfer, Access::eTransferWrite, Stage::eHost,
                   Access::eHostRead);
    commands.end();
}

void Device::Impl::submit() const {
    device.resetFences(*done);
    queue.submit(vk::SubmitInfo{{}, {}, *commands}, *done);
    while (device.waitForFences(*done, true, UINT64_MAX) == vk::Result::eTimeout) {
    }
}

std::optional<double> Device::Impl::measured_seconds() const {
    if (seconds_per_tick == 0.0) return std::nullopt;
    const auto [result, ticks] = timestamps.getResults<std::uint64_t>(
        0, kTimestampCount, kTimestampCount * sizeof(std::uint64_t), sizeof(std::uint64_t),
        vk::QueryResultFlagBits::e64 | vk::QueryResultFlagBits::eWait);
    if (result != vk::Result::eSuccess) return std::nullopt;
    return static_cast<double>(ticks[1] - ticks[0]) * seconds_per_tick;
}

void Kernel::Impl::create_layout(const vk::raii::Device& device,
                                 const std::vector<BufferArgument::Kind>& kinds) {
    std::vector<vk::DescriptorSetLayoutBinding> bindings;
    std::vector<vk::DescriptorPoolSize> sizes;
    for (std::uint32_t binding = 0; binding < kinds.size(); ++binding) {
        const vk::DescriptorType type = descriptor_type(kinds[binding]);
        bindings.emplace_back(binding, type, 1, vk::ShaderStageFlagBits::eCompute);
        sizes.emplace_back(type, 1);
    }
    set_layout = {device, vk::DescriptorSetLayoutCreateInfo{{}, bindings}};
    layout = {device, vk::PipelineLayoutCreateInfo{{}, *set_layout}};
    pool = {device, vk::DescriptorPoolCreateInfo{
                        vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, sizes}};
    set = std::move(
        vk::raii::DescriptorSets{device, vk::DescriptorSetAllocateInfo{*pool, *set_layout}}[0]);
}

Kernel::Impl::Impl(const vk::raii::Device& device, std::span<const std::uint32_t> spirv,
                   const std::string& entry_point, const std::vector<BufferArgument::Kind>& kinds) {
    create_layout(device, kinds);
    const vk::raii::ShaderModule shader{
        device, vk::ShaderModuleCreateInfo{{}, spirv.size_bytes(), spirv.data()}};
    const vk::PipelineShaderStageCreateInfo stage{
        {}, vk::ShaderStageFlagBits::eCompute, *shader, entry_point.c_str()};
    pipeline = {device, nullptr, vk::ComputePipelineCreateInfo{{}, stage, *layout}};
}

namespace {

// Calls `body`, turning Vulkan's exceptions into ours.
template <typename Body>
auto translating_errors(Body body) {
    try {
        return body();
    } catch (const vk::SystemError& error) {
        throw Error{fmt::format("Vulkan: {}", error.what())};
    }
}

}  // namespace

Device::Device(const DeviceOptions& options)
    : impl_{translating_errors([&] { return std::make_unique<Impl>(options); })} {}
Device::~Device() = default;
Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;

const std::string& Device::name() const {
    return impl_->name;
}

std::shared_ptr<ValidationLog> Device::validation_log() const {
    return impl_->log;
}

Kernel Device::compile(std::span<const std::uint32_t> spirv, const std::string& entry_point,
                       const std::vector<BufferArgument::Kind>& kinds) {
    return translating_errors([&] {
        auto kernel = std::make_unique<Kernel::Impl>(impl_->device, spirv, entry_point, kinds);
        impl_->throw_messages();
        return Kernel{std::move(kernel)};
    });
}

std::optional<double> Device::run(const Kernel& kernel, std::span<const BufferArgument> arguments,
                                  std::uint32_t groups) {
    return translating_errors([&] {
        impl_->upload(arguments);
        impl_->bind(kernel.impl(), arguments);
        impl_->record(kernel.impl(), arguments, groups);
        impl_->submit();
        for (std::size_t binding = 0; binding < arguments.size(); ++binding)
            if (arguments[binding].kind == BufferArgument::Kind::write)
                impl_->buffers[binding].read(arguments[binding].results);
        const auto seconds = impl_->measured_seconds();
        impl_->throw_messages();
        return seconds;
    });
}

Kernel::Kernel(std::unique_ptr<Impl> impl) : impl_{std::move(impl)} {}
Kernel::~Kernel() = default;
Kernel::Kernel(Kernel&&) noexcept = default;
Kernel& Kernel::operator=(Kernel&&) noexcept = default;

}  // namespace lacquer::vulkan
