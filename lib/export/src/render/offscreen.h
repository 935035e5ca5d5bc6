// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenGL without a window.
#pragma once

#include <memory>

namespace ncsim::exporter {

struct Gl;

/// OpenGL context of the compatibility profile, current in this thread until destruction,
/// without a framebuffer.
class OffscreenContext {
public:
    OffscreenContext() = default;
    virtual ~OffscreenContext() = default;
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// Functions of the context. Valid until the process ends.
    virtual const Gl& gl() const = 0;
};

/// Loads OSMesa at the first call. Throws std::runtime_error if OSMesa is not installed or provides
/// no context.
std::unique_ptr<OffscreenContext> osmesa_context();

}  // namespace ncsim::exporter
