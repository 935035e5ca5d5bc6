// SPDX-License-Identifier: GPL-3.0-or-later
//
// OpenGL context by EGL, for comparisons with the rasteriser.
#pragma once

#include "render/offscreen.h"

#include <memory>

namespace ncsim::exporter::test {

/// Returns an OpenGL context of EGL without a surface.
/// Throws: std::runtime_error if EGL provides no context.
std::unique_ptr<OffscreenContext> egl_context();

}  // namespace ncsim::exporter::test
