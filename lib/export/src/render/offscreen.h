// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenGL without a window.
#pragma once

#include <memory>

namespace ncsim::exporter {

struct Gl;

/// OpenGL context of the compatibility profile, without a framebuffer; current in this thread until
/// destruction.
class OffscreenContext {
public:
    OffscreenContext() = default;
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// Returns the functions of the context, which are valid until the process ends.
    virtual const Gl& gl() const = 0;
};

/// Returns a context of OSMesa, which is loaded at the first call.
/// Throws: std::runtime_error if OSMesa is not installed or provides no context.
std::unique_ptr<OffscreenContext> osmesa_context();

}  // namespace ncsim::exporter
