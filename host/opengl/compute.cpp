#include "opengl/compute.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "core/error.h"
#include "opengl/context.h"

namespace lacquer::opengl {

namespace {

GLenum target_of(BufferArgument::Kind kind) {
    return kind == BufferArgument::Kind::uniform ? GL_UNIFORM_BUFFER : GL_SHADER_STORAGE_BUFFER;
}

void throw_errors(const char* what) {
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw Error{fmt::format("OpenGL: {}: error {:#x}", what, error)};
}

// The driver's log of a shader or a program.
template <typename GetParameter, typename GetLog>
std::string log_of(GLuint object, GetParameter get_parameter, GetLog get_log) {
    GLint length = 0;
    get_parameter(object, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    get_log(object, length, nullptr, log.data());
    return log.c_str();
}

void compile_shader(GLuint shader, const std::string& source) {
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE)
        throw Error{fmt::format("OpenGL: the shader does not compile:\n{}",
                                log_of(shader, glGetShaderiv, glGetShaderInfoLog))};
}

void link_program(GLuint program, GLuint shader) {
    glAttachShader(program, shader);
    glLinkProgram(program);
    GLint linked = GL_FALSE;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    if (linked == GL_FALSE)
        throw Error{fmt::format("OpenGL: the program does not link:\n{}",
                                log_of(program, glGetProgramiv, glGetProgramInfoLog))};
}

// A buffer for one binding that grows as needed.
struct BindingBuffer {
    GLuint handle = 0;
    std::size_t capacity = 0;

    void reserve(std::size_t size) {
        if (handle == 0) glGenBuffers(1, &handle);
        glBindBuffer(GL_COPY_WRITE_BUFFER, handle);
        if (size <= capacity) return;
        capacity = std::bit_ceil(size);
        glBufferData(GL_COPY_WRITE_BUFFER, static_cast<GLsizeiptr>(capacity), nullptr,
                     GL_DYNAMIC_DRAW);
    }
};

}  // namespace

struct Context::Impl {
    EglContext egl;
    std::string renderer;
    std::vector<BindingBuffer> buffers;  // one per binding

    explicit Impl(Api api);
    void upload(std::span<const BufferArgument> arguments);
    void download(std::span<const BufferArgument> arguments) const;
    void dispatch(GLuint program, std::uint32_t groups) const;
};

Context::Impl::Impl(Api api) : egl{api} {
    renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

void Context::Impl::upload(std::span<const BufferArgument> arguments) {
    buffers.resize(std::max(buffers.size(), arguments.size()));
    for (std::size_t binding = 0; binding < arguments.size(); ++binding) {
        const BufferArgument& argument = arguments[binding];
        BindingBuffer& buffer = buffers[binding];
        buffer.reserve(argument.size());
        if (argument.kind != BufferArgument::Kind::write)
            glBufferSubData(GL_COPY_WRITE_BUFFER, 0, static_cast<GLsizeiptr>(argument.size()),
                            argument.bytes.data());
        glBindBufferRange(target_of(argument.kind), static_cast<GLuint>(binding), buffer.handle, 0,
                          static_cast<GLsizeiptr>(argument.size()));
    }
}

void Context::Impl::download(std::span<const BufferArgument> arguments) const {
    for (std::size_t binding = 0; binding < arguments.size(); ++binding) {
        const std::span<std::byte> results = arguments[binding].results;
        if (results.empty()) continue;
        glBindBuffer(GL_COPY_READ_BUFFER, buffers[binding].handle);
        const void* mapped = glMapBufferRange(
            GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(results.size()), GL_MAP_READ_BIT);
        if (mapped == nullptr) throw Error{"OpenGL: the results cannot be mapped"};
        std::memcpy(results.data(), mapped, results.size());
        glUnmapBuffer(GL_COPY_READ_BUFFER);
    }
}

void Context::Impl::dispatch(GLuint program, std::uint32_t groups) const {
    glUseProgram(program);
    glDispatchCompute(groups, 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
}

Context::Context(Api api) : impl_{std::make_unique<Impl>(api)} {}
Context::~Context() = default;
Context::Context(Context&&) noexcept = default;
Context& Context::operator=(Context&&) noexcept = default;

const std::string& Context::renderer() const {
    return impl_->renderer;
}

Program Context::compile(const std::string& source) {
    impl_->egl.make_current();
    const GLuint shader = glCreateShader(GL_COMPUTE_SHADER);
    const GLuint program = glCreateProgram();
    try {
        compile_shader(shader, source);
        link_program(program, shader);
    } catch (...) {
        glDeleteShader(shader);
        glDeleteProgram(program);
        throw;
    }
    glDeleteShader(shader);
    throw_errors("compiling");
    return Program{program};
}

void Context::run(const Program& program, std::span<const BufferArgument> arguments,
                  std::uint32_t groups) {
    impl_->egl.make_current();
    impl_->upload(arguments);
    impl_->dispatch(program.handle(), groups);
    impl_->download(arguments);
    throw_errors("dispatching");
}

}  // namespace lacquer::opengl
