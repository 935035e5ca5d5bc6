// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenGL contexts of OSMesa.
#include "render/gl.h"
#include "render/offscreen.h"

#include <GL/osmesa.h>

#include <array>
#include <stdexcept>

// OSMesa 22.3 keeps some 200 bytes of the framebuffer of each context until the process ends. This
// definition suppresses the report of the leak checker in sanitized builds.
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

class OsmesaContext final : public OffscreenContext {
public:
    OsmesaContext() {
        constexpr std::array<int, 5> kAttributes{OSMESA_FORMAT, OSMESA_RGBA, OSMESA_PROFILE,
                                                 OSMESA_COMPAT_PROFILE, 0};
        context_ = osmesa().create_context(kAttributes.data(), nullptr);
        if (context_ == nullptr ||
            osmesa().make_current(context_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
            throw std::runtime_error("cannot render: OSMesa provides no OpenGL context");
        }
    }
    ~OsmesaContext() override {
        osmesa().make_current(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        osmesa().destroy_context(context_);
    }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    const Gl& gl() const override { return osmesa().gl; }

private:
    OSMesaContext context_ = nullptr;
    std::array<GLubyte, 4> pixel_{};  // smallest framebuffer of a context
};

}  // namespace

std::unique_ptr<OffscreenContext> osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

}  // namespace ncsim::exporter
