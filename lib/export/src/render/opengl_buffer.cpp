// SPDX-License-Identifier: GPL-3.0-or-later
//
// Depth and stencil test with OpenGL; colours carry the numbers of surfaces.
#include "render/opengl_buffer.h"

#include "render/gl.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace ncsim::exporter {

namespace {

GLsizei to_size(std::uint32_t n) {
    return static_cast<GLsizei>(n);
}

}  // namespace

OpenGlBuffer::OpenGlBuffer(std::unique_ptr<OffscreenContext> context)
    : context_(std::move(context)), gl_(context_->gl()) {
    gl_.gen_framebuffers(1, &framebuffer_);
    gl_.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.gen_renderbuffers(2, renderbuffers_.data());
    // All operations that could change a number are disabled.
    gl_.disable(GL_DITHER);
    gl_.disable(GL_BLEND);
    gl_.disable(GL_CULL_FACE);
    gl_.shade_model(GL_FLAT);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depth_func(GL_LESS);
    gl_.pixel_storei(GL_PACK_ALIGNMENT, 1);
    gl_.enable_client_state(GL_VERTEX_ARRAY);
    gl_.enable_client_state(GL_COLOR_ARRAY);
    gl_.clear_color(0, 0, 0, 0);
    gl_.clear_depth(1.0);
    gl_.clear_stencil(0);
}

OpenGlBuffer::~OpenGlBuffer() {
    gl_.delete_framebuffers(1, &framebuffer_);
    gl_.delete_renderbuffers(2, renderbuffers_.data());
}

// Makes the framebuffer at least as large as the rectangle.
void OpenGlBuffer::resize() {
    width_ = std::max(width_, rect_.width);
    height_ = std::max(height_, rect_.height);
    gl_.bind_renderbuffer(GL_RENDERBUFFER, renderbuffers_[0]);
    gl_.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, to_size(width_), to_size(height_));
    gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 renderbuffers_[0]);
    gl_.bind_renderbuffer(GL_RENDERBUFFER, renderbuffers_[1]);
    gl_.renderbuffer_storage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, to_size(width_),
                             to_size(height_));
    gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                 renderbuffers_[1]);
    if (gl_.check_framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        gl_.get_error() != GL_NO_ERROR) {
        throw std::runtime_error("cannot render: OpenGL has no framebuffer of this size");
    }
}

void OpenGlBuffer::begin(const SampleRect& rect) {
    rect_ = rect;
    if (rect.width > width_ || rect.height > height_) resize();
    gl_.viewport(0, 0, to_size(rect.width), to_size(rect.height));
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

void OpenGlBuffer::peel(SurfaceId /*last*/) {
    throw std::runtime_error("cannot render a transparent part with OSMesa");
}

// Appends the triangles of the polygon in clip coordinates. Rows of the framebuffer run downwards,
// like rows of the picture.
void OpenGlBuffer::append_fan(std::span<const ScreenPoint> polygon, SurfaceId id) {
    const std::array<std::uint8_t, 4> bytes{
        static_cast<std::uint8_t>(id & 0xFF), static_cast<std::uint8_t>((id >> 8) & 0xFF),
        static_cast<std::uint8_t>((id >> 16) & 0xFF), static_cast<std::uint8_t>(id >> 24)};
    const auto along = [this](double at, double w, std::int64_t begin, std::uint32_t cells) {
        const double in_rect = (at - static_cast<double>(begin) * w) / rect_.cell;
        return static_cast<float>(2.0 * in_rect / cells - w);
    };
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        for (const std::size_t corner : {std::size_t{0}, i - 1, i}) {
            const ScreenPoint& p = polygon[corner];
            pending_.push_back(
                {{along(p.x, p.w, rect_.x, rect_.width), along(p.y, p.w, rect_.y, rect_.height),
                  static_cast<float>(p.z), static_cast<float>(p.w)},
                 bytes});
        }
    }
}

void OpenGlBuffer::flush() {
    if (pending_.empty()) return;
    gl_.vertex_pointer(4, GL_FLOAT, sizeof(Vertex), pending_.front().position.data());
    gl_.color_pointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), pending_.front().id.data());
    gl_.draw_arrays(GL_TRIANGLES, 0, static_cast<GLsizei>(pending_.size()));
    pending_.clear();
}

void OpenGlBuffer::draw(std::span<const ScreenPoint> polygon, SurfaceId id) {
    constexpr std::size_t kMost = 3U << 14;  // vertices at once
    append_fan(polygon, id);
    if (pending_.size() >= kMost) flush();
}

void OpenGlBuffer::draw(std::span<const ScreenPoint> polygon, SurfaceId id,
                        std::span<const std::vector<ScreenPoint>> masks) {
    flush();
    gl_.clear(GL_STENCIL_BUFFER_BIT);
    gl_.enable(GL_STENCIL_TEST);
    // Masks are drawn into the stencil buffer only, without a depth test.
    gl_.color_mask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.disable(GL_DEPTH_TEST);
    gl_.stencil_func(GL_ALWAYS, 1, 0xFF);
    gl_.stencil_op(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (const auto& mask : masks)
        append_fan(mask, id);
    flush();
    // The facet is drawn if the stencil is not set.
    gl_.color_mask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.enable(GL_DEPTH_TEST);
    gl_.stencil_func(GL_NOTEQUAL, 1, 0xFF);
    gl_.stencil_op(GL_KEEP, GL_KEEP, GL_KEEP);
    append_fan(polygon, id);
    flush();
    gl_.disable(GL_STENCIL_TEST);
}

std::span<const SurfaceId> OpenGlBuffer::ids() {
    flush();
    std::vector<std::uint8_t> bytes(std::size_t{4} * rect_.width * rect_.height);
    gl_.read_pixels(0, 0, to_size(rect_.width), to_size(rect_.height), GL_RGBA, GL_UNSIGNED_BYTE,
                    bytes.data());
    if (gl_.get_error() != GL_NO_ERROR)
        throw std::runtime_error("cannot render: OpenGL reported an error");
    ids_.clear();
    for (std::size_t i = 0; i < bytes.size(); i += 4) {
        ids_.push_back(SurfaceId{bytes[i]} | SurfaceId{bytes[i + 1]} << 8 |
                       SurfaceId{bytes[i + 2]} << 16 | SurfaceId{bytes[i + 3]} << 24);
    }
    return ids_;
}

}  // namespace ncsim::exporter
