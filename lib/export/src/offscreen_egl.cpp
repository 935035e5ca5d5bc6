// SPDX-License-Identifier: GPL-3.0-or-later
//
// EGL_MESA_platform_surfaceless: an OpenGL context that never had a surface.
#include "offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdexcept>

namespace ncsim::exporter {

struct OffscreenContext::Handle {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Handle() {
        if (display == EGL_NO_DISPLAY) return;
        eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) eglDestroyContext(display, context);
        // The display is shared by all contexts of the process: it stays initialised.
    }
};

OffscreenContext::OffscreenContext() : handle_(std::make_unique<Handle>()) {
    handle_->display =
        eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (handle_->display == EGL_NO_DISPLAY ||
        eglInitialize(handle_->display, nullptr, nullptr) != EGL_TRUE ||
        eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
        throw std::runtime_error("cannot render: EGL has no surfaceless OpenGL");
    }
    handle_->context =
        eglCreateContext(handle_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (handle_->context == EGL_NO_CONTEXT ||
        eglMakeCurrent(handle_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_->context) !=
            EGL_TRUE) {
        throw std::runtime_error("cannot render: EGL gives no OpenGL context");
    }
}

OffscreenContext::~OffscreenContext() = default;

}  // namespace ncsim::exporter
