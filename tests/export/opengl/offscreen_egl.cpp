// SPDX-License-Identifier: GPL-3.0-or-later
//
// EGL_MESA_platform_surfaceless: OpenGL context without a surface.
#include "opengl/offscreen_egl.h"

#include "render/gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <stdexcept>

namespace ncsim::exporter::test {

namespace {

// Functions of the dispatch libraries for the drivers of all vendors.
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

class EglContext final : public OffscreenContext {
public:
    EglContext() {
        display_ =
            egl().get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY ||
            egl().initialize(display_, nullptr, nullptr) != EGL_TRUE ||
            egl().bind_a_p_i(EGL_OPENGL_API) != EGL_TRUE) {
            throw std::runtime_error("cannot render: EGL has no surfaceless OpenGL");
        }
        context_ = egl().create_context(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
        if (context_ == EGL_NO_CONTEXT ||
            egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
            throw std::runtime_error("cannot render: EGL gives no OpenGL context");
        }
    }
    // The display stays initialised, because all contexts of the process share the display.
    ~EglContext() override {
        egl().make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl().destroy_context(display_, context_);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    const Gl& gl() const override { return egl().gl; }

private:
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<OffscreenContext> egl_context() {
    return std::make_unique<EglContext>();
}

}  // namespace ncsim::exporter::test
