// SPDX-License-Identifier: GPL-3.0-or-later
//
// EGL_MESA_platform_surfaceless: OpenGL context without a surface.
#include "opengl/gl.h"
#include "opengl/offscreen.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdexcept>

namespace ncsim::exporter::test {

namespace {

// Names of the dispatch library of all vendors.
struct Egl {
    SharedLibrary opengl{"libOpenGL.so.0"};
    SharedLibrary library{"libEGL.so.1"};
    Gl gl{opengl};
    decltype(&eglBindAPI) bind_a_p_i = nullptr;
    decltype(&eglCreateContext) create_context = nullptr;
    decltype(&eglDestroyContext) destroy_context = nullptr;
    decltype(&eglGetPlatformDisplay) get_platform_display = nullptr;
    decltype(&eglInitialize) initialize = nullptr;
    decltype(&eglMakeCurrent) make_current = nullptr;

    Egl() {
        library.find(bind_a_p_i, "eglBindAPI");
        library.find(create_context, "eglCreateContext");
        library.find(destroy_context, "eglDestroyContext");
        library.find(get_platform_display, "eglGetPlatformDisplay");
        library.find(initialize, "eglInitialize");
        library.find(make_current, "eglMakeCurrent");
    }
};

const Egl& egl() {
    static const Egl loaded;
    return loaded;
}

}  // namespace

struct OffscreenContext::Handle {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;

    ~Handle() {
        if (display == EGL_NO_DISPLAY) return;
        egl().make_current(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context != EGL_NO_CONTEXT) egl().destroy_context(display, context);
        // The display stays initialised, because all contexts of the process share the display.
    }
};

OffscreenContext::OffscreenContext() : handle_(std::make_unique<Handle>()) {
    handle_->display =
        egl().get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (handle_->display == EGL_NO_DISPLAY ||
        egl().initialize(handle_->display, nullptr, nullptr) != EGL_TRUE ||
        egl().bind_a_p_i(EGL_OPENGL_API) != EGL_TRUE) {
        throw std::runtime_error("cannot render: EGL has no surfaceless OpenGL");
    }
    handle_->context =
        egl().create_context(handle_->display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (handle_->context == EGL_NO_CONTEXT ||
        egl().make_current(handle_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handle_->context) !=
            EGL_TRUE) {
        throw std::runtime_error("cannot render: EGL gives no OpenGL context");
    }
}

OffscreenContext::~OffscreenContext() = default;

const Gl& OffscreenContext::gl() const {
    return egl().gl;
}

}  // namespace ncsim::exporter::test
