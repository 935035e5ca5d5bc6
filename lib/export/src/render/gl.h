// SPDX-License-Identifier: GPL-3.0-or-later
//
// Functions of OpenGL, from a library that is loaded with the first context.
#pragma once

#include "render/shared_library.h"

#define GL_GLEXT_PROTOTYPES  // NOLINT(readability-identifier-naming): of OpenGL
#include <GL/gl.h>
#include <GL/glext.h>

namespace ncsim::exporter {

/// Table of OpenGL functions.
struct Gl {
    explicit Gl(const SharedLibrary& library);

    decltype(&::glBindFramebuffer) bind_framebuffer = nullptr;
    decltype(&::glBindRenderbuffer) bind_renderbuffer = nullptr;
    decltype(&::glCheckFramebufferStatus) check_framebuffer_status = nullptr;
    decltype(&::glClear) clear = nullptr;
    decltype(&::glClearColor) clear_color = nullptr;
    decltype(&::glClearDepth) clear_depth = nullptr;
    decltype(&::glClearStencil) clear_stencil = nullptr;
    decltype(&::glColorMask) color_mask = nullptr;
    decltype(&::glColorPointer) color_pointer = nullptr;
    decltype(&::glDeleteFramebuffers) delete_framebuffers = nullptr;
    decltype(&::glDeleteRenderbuffers) delete_renderbuffers = nullptr;
    decltype(&::glDepthFunc) depth_func = nullptr;
    decltype(&::glDisable) disable = nullptr;
    decltype(&::glDrawArrays) draw_arrays = nullptr;
    decltype(&::glEnable) enable = nullptr;
    decltype(&::glEnableClientState) enable_client_state = nullptr;
    decltype(&::glFramebufferRenderbuffer) framebuffer_renderbuffer = nullptr;
    decltype(&::glGenFramebuffers) gen_framebuffers = nullptr;
    decltype(&::glGenRenderbuffers) gen_renderbuffers = nullptr;
    decltype(&::glGetError) get_error = nullptr;
    decltype(&::glGetIntegerv) get_integerv = nullptr;
    decltype(&::glPixelStorei) pixel_storei = nullptr;
    decltype(&::glReadPixels) read_pixels = nullptr;
    decltype(&::glRenderbufferStorage) renderbuffer_storage = nullptr;
    decltype(&::glShadeModel) shade_model = nullptr;
    decltype(&::glStencilFunc) stencil_func = nullptr;
    decltype(&::glStencilOp) stencil_op = nullptr;
    decltype(&::glVertexPointer) vertex_pointer = nullptr;
    decltype(&::glViewport) viewport = nullptr;
};

}  // namespace ncsim::exporter
