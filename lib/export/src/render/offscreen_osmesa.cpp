// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/gl.h"
#include "render/offscreen.h"

#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

// OSMesa 22.3 keeps the framebuffer of each context until the process ends, some 200 bytes. The
// leak checker of sanitized builds is told so here, for every program that renders.
#if defined(__SANITIZE_ADDRESS__)
#define NCSIM_HAS_LEAK_CHECKER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define NCSIM_HAS_LEAK_CHECKER 1
#endif
#endif
#ifdef NCSIM_HAS_LEAK_CHECKER
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa.so";
}
#endif

namespace ncsim::exporter {

namespace {

struct Osmesa {
    SharedLibrary library{NCSIM_OSMESA_LIBRARY};
    Gl gl{library};
    decltype(&OSMesaCreateContextAttribs) create_context = nullptr;
    decltype(&OSMesaMakeCurrent) make_current = nullptr;
    decltype(&OSMesaDestroyContext) destroy_context = nullptr;

    Osmesa() {
        library.find(create_context, "OSMesaCreateContextAttribs");
        library.find(make_current, "OSMesaMakeCurrent");
        library.find(destroy_context, "OSMesaDestroyContext");
    }
};

const Osmesa& osmesa() {
    static const Osmesa loaded;
    return loaded;
}

}  // namespace

struct OffscreenContext::Handle {
    OSMesaContext context = nullptr;
    std::array<GLubyte, 4> pixel{};  // OSMesa insists on a framebuffer of its own

    ~Handle() {
        if (context == nullptr) return;
        osmesa().make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        osmesa().destroy_context(context);
    }
};

OffscreenContext::OffscreenContext() : handle_(std::make_unique<Handle>()) {
    constexpr std::array<int, 5> kAttributes{OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE,
                                             OSMESA_COMPAT_PROFILE, 0};
    handle_->context = osmesa().create_context(kAttributes.data(), nullptr);
    if (handle_->context == nullptr ||
        osmesa().make_current(handle_->context, handle_->pixel.data(), GL_UNSIGNED_BYTE, 1, 1) !=
            GL_TRUE) {
        throw std::runtime_error("cannot render: OSMesa gives no OpenGL context");
    }
}

OffscreenContext::~OffscreenContext() = default;

const Gl& OffscreenContext::gl() const {
    return osmesa().gl;
}

}  // namespace ncsim::exporter
