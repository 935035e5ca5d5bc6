// SPDX-License-Identifier: GPL-3.0-or-later
#include "offscreen.h"

#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

namespace ncsim::exporter {

struct OffscreenContext::Handle {
    OSMesaContext context = nullptr;
    std::array<GLubyte, 4> pixel{};  // OSMesa insists on a framebuffer of its own

    ~Handle() {
        if (context != nullptr) OSMesaDestroyContext(context);
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
