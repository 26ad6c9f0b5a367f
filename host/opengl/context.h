// An OpenGL context without a window. For source files only.
#pragma once

#include <string>

#include <epoxy/egl.h>

#include "opengl/compute.h"

namespace lacquer::opengl {

// Owns an EGL context on the surfaceless platform.
class EglContext {
 public:
    explicit EglContext(Api api);
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void make_current() const;

 private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace lacquer::opengl
