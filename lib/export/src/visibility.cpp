// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stencil buffer as in Schüppel 2001, section 5.1, with one change: the masks of each
// facet are written with a number of their own, so that nothing has to be cleared after a
// facet, and a mask that reaches over the facet's edge by a rounding cannot hit the next one.
#include "visibility.h"

#define GL_GLEXT_PROTOTYPES  // NOLINT(readability-identifier-naming): of OpenGL
#include <GL/gl.h>
#include <GL/glext.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace ncsim::exporter {

namespace {

// A sine.
constexpr double kGrazing = 1e-6;

constexpr std::int32_t kLastStencilValue = 255;
// Vertices collected before they are handed to OpenGL: some megabytes.
constexpr std::size_t kBatch = std::size_t{3} * 65536;

[[noreturn]] void fail(std::uint32_t width, std::uint32_t height) {
    throw std::runtime_error("cannot render: OpenGL has no framebuffer of " +
                             std::to_string(width) + " by " + std::to_string(height) + " samples");
}

GLsizei to_size(std::uint32_t n) {
    return static_cast<GLsizei>(n);
}

}  // namespace

// --- ScreenMap ---------------------------------------------------------------------------

ScreenMap::ScreenMap(const Camera& camera, double width, double height)
    : camera_(camera), width_(width), height_(height) {}

cda::Vec3 ScreenMap::direction_in_camera(cda::Vec3 v_W) const {
    return {cda::dot(camera_.right, v_W), cda::dot(camera_.up, v_W), cda::dot(camera_.back, v_W)};
}

cda::Vec3 ScreenMap::point_in_camera(cda::Vec3 p_W) const {
    return direction_in_camera(p_W - camera_.target);
}

ScreenPoint ScreenMap::operator()(cda::Vec3 p_W) const {
    const cda::Vec3 p_C = point_in_camera(p_W);
    const double samples_per_mm = height_ / camera_.height;
    const double range = camera_.depth;
    if (camera_.is_orthographic()) {
        return {0.5 * width_ + samples_per_mm * p_C.x, 0.5 * height_ - samples_per_mm * p_C.y,
                -p_C.z / range, 1.0};
    }
    // Seen from the eye at z = d: sizes shrink by d / (d - z). Depth is chosen linear in 1 / w, -1
    // at z = range and 1 at z = -range, as the hardware interpolates it.
    const double d = camera_.distance;
    const double w = (d - p_C.z) / d;
    const double near = (d - range) / d;
    const double far = (d + range) / d;
    return {0.5 * width_ * w + samples_per_mm * p_C.x, 0.5 * height_ * w - samples_per_mm * p_C.y,
            ((far + near) * w - 2.0 * far * near) / (far - near), w};
}

bool faces_camera(const Camera& camera, cda::Vec3 normal, cda::Vec3 point) {
    const cda::Vec3 towards_eye =
        camera.is_orthographic()
            ? camera.back
            : cda::normalized(camera.target + camera.distance * camera.back - point);
    return cda::dot(normal, towards_eye) > kGrazing;
}

// --- VisibilityBuffer --------------------------------------------------------------------

VisibilityBuffer::VisibilityBuffer(std::uint32_t width, std::uint32_t height)
    : width_(width), height_(height) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (std::max(width, height) > static_cast<std::uint32_t>(std::max(largest, 0))) {
        fail(width, height);
    }
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenRenderbuffers(2, renderbuffers_.data());
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, to_size(width), to_size(height));
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              renderbuffers_[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, renderbuffers_[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, to_size(width), to_size(height));
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                              renderbuffers_[1]);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        glGetError() != GL_NO_ERROR) {
        fail(width, height);
    }
    // Everything that could make a number into another number is off.
    glDisable(GL_DITHER);
    glDisable(GL_BLEND);
    glDisable(GL_CULL_FACE);
    glShadeModel(GL_FLAT);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glEnableClientState(GL_VERTEX_ARRAY);
    glEnableClientState(GL_COLOR_ARRAY);
}

VisibilityBuffer::~VisibilityBuffer() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(2, renderbuffers_.data());
}

void VisibilityBuffer::begin(const SampleRect& rect) {
    rect_ = rect;
    pending_.clear();
    stencil_value_ = 0;
    glViewport(0, 0, to_size(rect.width), to_size(rect.height));
    glClearColor(0, 0, 0, 0);
    glClearDepth(1.0);
    glClearStencil(0);
    glDisable(GL_STENCIL_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
}

bool VisibilityBuffer::is_outside(std::span<const ScreenPoint> polygon) const {
    const auto left = static_cast<double>(rect_.x);
    const auto top = static_cast<double>(rect_.y);
    const double right = left + rect_.width;
    const double bottom = top + rect_.height;
    const auto all = [&](auto beyond) {
        return std::all_of(polygon.begin(), polygon.end(), beyond);
    };
    return all([&](const ScreenPoint& p) { return p.x < left * p.w; }) ||
           all([&](const ScreenPoint& p) { return p.x > right * p.w; }) ||
           all([&](const ScreenPoint& p) { return p.y < top * p.w; }) ||
           all([&](const ScreenPoint& p) { return p.y > bottom * p.w; });
}

// Appends the triangles of the polygon in clip coordinates of the rectangle. Its rows run
// downwards in the framebuffer too, so they are read back in the order of the picture.
void VisibilityBuffer::append_fan(std::span<const ScreenPoint> polygon, SurfaceId id) {
    const std::array<std::uint8_t, 4> bytes{
        static_cast<std::uint8_t>(id & 0xFF), static_cast<std::uint8_t>((id >> 8) & 0xFF),
        static_cast<std::uint8_t>((id >> 16) & 0xFF), static_cast<std::uint8_t>(id >> 24)};
    const auto vertex = [&](const ScreenPoint& p) {
        const double x = p.x - static_cast<double>(rect_.x) * p.w;
        const double y = p.y - static_cast<double>(rect_.y) * p.w;
        return Vertex{{static_cast<float>(2.0 * x / rect_.width - p.w),
                       static_cast<float>(2.0 * y / rect_.height - p.w), static_cast<float>(p.z),
                       static_cast<float>(p.w)},
                      bytes};
    };
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        pending_.push_back(vertex(polygon[0]));
        pending_.push_back(vertex(polygon[i - 1]));
        pending_.push_back(vertex(polygon[i]));
    }
}

void VisibilityBuffer::flush() {
    if (pending_.empty()) return;
    glVertexPointer(4, GL_FLOAT, sizeof(Vertex), pending_.front().position.data());
    glColorPointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), pending_.front().id.data());
    glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(pending_.size()));
    pending_.clear();
}

void VisibilityBuffer::draw(std::span<const ScreenPoint> polygon, SurfaceId id) {
    if (is_outside(polygon)) return;
    append_fan(polygon, id);
    if (pending_.size() >= kBatch) flush();
}

void VisibilityBuffer::next_stencil_value() {
    if (stencil_value_ == kLastStencilValue) {
        glClear(GL_STENCIL_BUFFER_BIT);
        stencil_value_ = 0;
    }
    ++stencil_value_;
}

void VisibilityBuffer::draw(std::span<const ScreenPoint> polygon, SurfaceId id,
                            std::span<const std::vector<ScreenPoint>> masks) {
    if (masks.empty()) return draw(polygon, id);
    if (is_outside(polygon)) return;
    flush();
    next_stencil_value();
    glEnable(GL_STENCIL_TEST);

    // The masks, into the stencil buffer only, whatever lies before them.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glDisable(GL_DEPTH_TEST);
    glStencilFunc(GL_ALWAYS, stencil_value_, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (const auto& mask : masks) {
        if (!is_outside(mask)) append_fan(mask, id);
    }
    flush();

    // The facet itself, where the stencil was not set.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glEnable(GL_DEPTH_TEST);
    glStencilFunc(GL_NOTEQUAL, stencil_value_, 0xFF);
    glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    append_fan(polygon, id);
    flush();
    glDisable(GL_STENCIL_TEST);
}

void VisibilityBuffer::read(std::vector<SurfaceId>& ids) {
    flush();
    const std::size_t count = std::size_t{rect_.width} * rect_.height;
    std::vector<std::uint8_t> bytes(4 * count);
    glReadPixels(0, 0, to_size(rect_.width), to_size(rect_.height), GL_RGBA, GL_UNSIGNED_BYTE,
                 bytes.data());
    if (glGetError() != GL_NO_ERROR) {
        throw std::runtime_error("cannot render: OpenGL reported an error");
    }
    ids.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* from = &bytes[4 * i];
        ids[i] = SurfaceId{from[0]} | SurfaceId{from[1]} << 8 | SurfaceId{from[2]} << 16 |
                 SurfaceId{from[3]} << 24;
    }
}

}  // namespace ncsim::exporter
