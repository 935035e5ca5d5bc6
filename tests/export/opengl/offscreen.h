// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenGL without a window, by EGL without a surface.
#pragma once

#include <memory>

namespace ncsim::exporter::test {

struct Gl;

/// OpenGL context of the compatibility profile, current in this thread until its destruction,
/// without a framebuffer. Throws std::runtime_error if EGL provides no context.
class OffscreenContext {
public:
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// Functions of the context. Valid until the process ends.
    const Gl& gl() const;

private:
    struct Handle;
    std::unique_ptr<Handle> handle_;
};

}  // namespace ncsim::exporter::test
