// What a compute kernel is given, in terms that every graphics interface shares.
#pragma once

#include <cstddef>
#include <span>

namespace lacquer {

// One buffer of the host's memory bound to a kernel. Its place in a list is its binding.
struct BufferArgument {
    enum class Kind { uniform, read, write };

    Kind kind = Kind::read;
    std::span<const std::byte> bytes;  // uniform, read: what the kernel is given
    std::span<std::byte> results;      // write: where what the kernel wrote is put

    std::size_t size() const { return kind == Kind::write ? results.size() : bytes.size(); }
};

}  // namespace lacquer
