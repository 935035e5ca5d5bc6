// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenGL without a window. One of two sources implements it, chosen by CMake: OSMesa where it is
// there, EGL without a surface where not (Mesa has dropped OSMesa since). Either is loaded with the
// first context: a program that draws nothing does without.
#pragma once

#include <memory>

namespace ncsim::exporter {

struct Gl;

/// An OpenGL context of the compatibility profile, current in this thread while it lives. It has no
/// framebuffer worth drawing to: bring your own. Throws std::runtime_error if there can be none.
class OffscreenContext {
public:
    OffscreenContext();
    ~OffscreenContext();
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;

    /// What draws into it. Lives as long as the process.
    const Gl& gl() const;

private:
    struct Handle;
    std::unique_ptr<Handle> handle_;
};

}  // namespace ncsim::exporter
