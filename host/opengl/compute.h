// Compute kernels on OpenGL without a window: buffers in, one dispatch, buffers out. Knows no BSDF.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "core/buffer_argument.h"

namespace lacquer::opengl {

enum class Api { opengl, gles };  // OpenGL 4.5 core, OpenGL ES 3.1

class Program;

// A context of its own. Everything throws Error with the driver's message. One thread at a time.
class Context {
 public:
    // Uses Mesa's software renderer unless LIBGL_ALWAYS_SOFTWARE says otherwise. Throws Unavailable
    // where EGL, its surfaceless platform, or the version of the API is missing.
    explicit Context(Api api);
    ~Context();
    Context(Context&&) noexcept;
    Context& operator=(Context&&) noexcept;

    // As the driver reports it: "llvmpipe (LLVM 15.0.6, 256 bits)".
    const std::string& renderer() const;

    // Compiles and links the compute shader `source`.
    Program compile(const std::string& source);

    // Gives the program its buffers, dispatches `groups` workgroups, and fetches the results.
    void run(const Program& program, std::span<const BufferArgument> arguments,
             std::uint32_t groups);

    struct Impl;

 private:
    std::unique_ptr<Impl> impl_;
};

// A compiled program. It goes with its context.
class Program {
 public:
    explicit Program(unsigned handle) : handle_{handle} {}
    unsigned handle() const { return handle_; }

 private:
    unsigned handle_;
};

}  // namespace lacquer::opengl
