// SPDX-License-Identifier: GPL-3.0-or-later
#include "offscreen.h"

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

struct OffscreenContext::Handle {
    OSMesaContext context = nullptr;
    std::array<GLubyte, 4> pixel{};  // OSMesa insists on a framebuffer of its own

    ~Handle() {
        if (context == nullptr) return;
        OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        OSMesaDestroyContext(context);
    }
};

OffscreenContext::OffscreenContext() : handle_(std::make_unique<Handle>()) {
    constexpr std::array<int, 5> kAttributes{OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE,
                                             OSMESA_COMPAT_PROFILE, 0};
    handle_->context = OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
    if (handle_->context == nullptr || OSMesaMakeCurrent(handle_->context, handle_->pixel.data(),
                                                         GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
        throw std::runtime_error("cannot render: OSMesa gives no OpenGL context");
    }
}

OffscreenContext::~OffscreenContext() = default;

}  // namespace ncsim::exporter
