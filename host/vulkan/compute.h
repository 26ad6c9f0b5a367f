// Compute kernels on a Vulkan device: buffers in, one dispatch, buffers out. Knows no BSDF.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/buffer_argument.h"
#include "vulkan/validation.h"

namespace lacquer::vulkan {

struct DeviceOptions {
    // Index, or part of the name (letter case ignored), among all installed devices. Empty: the
    // first device of the default driver.
    std::string device;
    // Turns the validation layers on; every message of theirs is then an Error.
    bool validation = false;
};

class Kernel;

// A device that can compute. Everything throws Error with the text of the call and the result.
// One thread at a time.
class Device {
 public:
    // Throws Error saying why there is none: no loader, no driver, no such device (with the list of
    // those found), too old, no validation layer.
    explicit Device(const DeviceOptions& options);
    ~Device();
    Device(Device&&) noexcept;
    Device& operator=(Device&&) noexcept;

    // As the driver reports it: "llvmpipe (LLVM 15.0.6, 256 bits)".
    const std::string& name() const;

    // Compiles `spirv`, whose buffers in set 0 are of `kinds`, in the order of their bindings.
    Kernel compile(std::span<const std::uint32_t> spirv, const std::string& entry_point,
                   const std::vector<BufferArgument::Kind>& kinds);

    // Gives the kernel its buffers, dispatches `groups` workgroups, and fetches the results.
    // Returns the seconds that the dispatch took on the device's own clock, where it has one.
    std::optional<double> run(const Kernel& kernel, std::span<const BufferArgument> arguments,
                              std::uint32_t groups);

    // Outlives the device, to tell what the validation layers said when it went.
    std::shared_ptr<ValidationLog> validation_log() const;

    struct Impl;

 private:
    std::unique_ptr<Impl> impl_;
};

// A compiled kernel. Must go before its device.
class Kernel {
 public:
    struct Impl;

    explicit Kernel(std::unique_ptr<Impl> impl);
    ~Kernel();
    Kernel(Kernel&&) noexcept;
    Kernel& operator=(Kernel&&) noexcept;

    const Impl& impl() const { return *impl_; }

 private:
    std::unique_ptr<Impl> impl_;
};

}  // namespace lacquer::vulkan
