#include "opengl/context.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string_view>

#include "core/environment.h"
#include "core/error.h"

namespace lacquer::opengl {

namespace {

struct Requirement {
    const char* library;
    const char* package;
};

// libepoxy ends the process when it cannot load a library: try each before.
void require_library(const Requirement& requirement) {
    void* library = dlopen(requirement.library, RTLD_LAZY | RTLD_LOCAL);
    if (library == nullptr)
        throw Unavailable{fmt::format("{} cannot be loaded ({})", requirement.library, dlerror()),
                          fmt::format("apt-get install {}", requirement.package)};
    dlclose(library);
}

void require_libraries(Api api) {
    require_library({"libEGL.so.1", "libegl1"});
    if (api == Api::opengl)
        require_library({"libGL.so.1", "libgl1"});
    else
        require_library({"libGLESv2.so.2", "libgles2"});
}

bool has_extension(const char* extensions, std::string_view wanted) {
    if (extensions == nullptr) return false;
    // Names are separated by spaces, and one may be the beginning of another.
    const std::string list = fmt::format(" {} ", extensions);
    return list.find(fmt::format(" {} ", wanted)) != std::string::npos;
}

[[noreturn]] void throw_no_driver(std::string_view why) {
    throw Unavailable{fmt::format("EGL has no driver that works without a window ({})", why),
                      "apt-get install libegl-mesa0 libgl1-mesa-dri"};
}

EGLDisplay surfaceless_display() {
    if (!has_extension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS),
                       "EGL_MESA_platform_surfaceless"))
        throw_no_driver("no EGL_MESA_platform_surfaceless");
    EGLDisplay display =
        eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY) throw_no_driver("no surfaceless display");
    // Never terminated: every context of the process shares this display.
    if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
        throw_no_driver(fmt::format("eglInitialize: {:#x}", eglGetError()));
    return display;
}

EGLContext create_context(EGLDisplay display, Api api) {
    const bool desktop = api == Api::opengl;
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, desktop ? 4 : 3, EGL_CONTEXT_MINOR_VERSION,
                              desktop ? 5 : 1, EGL_NONE};
    EGLContext context = EGL_NO_CONTEXT;
    if (eglBindAPI(desktop ? EGL_OPENGL_API : EGL_OPENGL_ES_API) == EGL_TRUE)
        context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
    if (context == EGL_NO_CONTEXT)
        throw Unavailable{fmt::format("the EGL driver offers no {} (error {:#x})",
                                      desktop ? "OpenGL 4.5" : "OpenGL ES 3.1", eglGetError()),
                          "apt-get install libgl1-mesa-dri"};
    return context;
}

}  // namespace

EglContext::EglContext(Api api) {
    ensure_runtime_folder();
    require_libraries(api);
    ScopedEnvironment environment;
    if (!environment_variable("LIBGL_ALWAYS_SOFTWARE"))
        environment.set("LIBGL_ALWAYS_SOFTWARE", "1");
    display_ = surfaceless_display();
    context_ = create_context(display_, api);
    make_current();
}

EglContext::~EglContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

void EglContext::make_current() const {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
        throw Error{fmt::format("EGL: eglMakeCurrent: {:#x}", eglGetError())};
}

}  // namespace lacquer::opengl
