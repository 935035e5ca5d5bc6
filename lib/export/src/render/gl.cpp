// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lookup of the OpenGL functions in the library.
#include "render/gl.h"

namespace ncsim::exporter {

Gl::Gl(const SharedLibrary& library) {
    library.find(bind_framebuffer, "glBindFramebuffer");
    library.find(bind_renderbuffer, "glBindRenderbuffer");
    library.find(check_framebuffer_status, "glCheckFramebufferStatus");
    library.find(clear, "glClear");
    library.find(clear_color, "glClearColor");
    library.find(clear_depth, "glClearDepth");
    library.find(clear_stencil, "glClearStencil");
    library.find(color_mask, "glColorMask");
    library.find(color_pointer, "glColorPointer");
    library.find(delete_framebuffers, "glDeleteFramebuffers");
    library.find(delete_renderbuffers, "glDeleteRenderbuffers");
    library.find(depth_func, "glDepthFunc");
    library.find(disable, "glDisable");
    library.find(draw_arrays, "glDrawArrays");
    library.find(enable, "glEnable");
    library.find(enable_client_state, "glEnableClientState");
    library.find(framebuffer_renderbuffer, "glFramebufferRenderbuffer");
    library.find(gen_framebuffers, "glGenFramebuffers");
    library.find(gen_renderbuffers, "glGenRenderbuffers");
    library.find(get_error, "glGetError");
    library.find(get_integerv, "glGetIntegerv");
    library.find(pixel_storei, "glPixelStorei");
    library.find(read_pixels, "glReadPixels");
    library.find(renderbuffer_storage, "glRenderbufferStorage");
    library.find(shade_model, "glShadeModel");
    library.find(stencil_func, "glStencilFunc");
    library.find(stencil_op, "glStencilOp");
    library.find(vertex_pointer, "glVertexPointer");
    library.find(viewport, "glViewport");
}

}  // namespace ncsim::exporter
