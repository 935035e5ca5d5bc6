// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stencil buffer as in Schüppel 2001, section 5.1, with one change: the masks of each
// facet are written with a number of their own, so that nothing has to be cleared after a
// facet, and a mask that reaches over the facet's edge by a rounding cannot hit the next one.
#include "render/visibility.h"

#include "render/gl.h"

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
    : gl_(context_.gl()), width_(width), height_(height) {
    GLint largest = 0;
    gl_.get_integerv(GL_MAX_RENDERBUFFER_SIZE, &largest);
    if (std::max(width, height) > static_cast<std::uint32_t>(std::max(largest, 0))) {
        fail(width, height);
    }
    gl_.gen_framebuffers(1, &framebuffer_);
    gl_.bind_framebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.gen_renderbuffers(2, renderbuffers_.data());
    gl_.bind_renderbuffer(GL_RENDERBUFFER, renderbuffers_[0]);
    gl_.renderbuffer_storage(GL_RENDERBUFFER, GL_RGBA8, to_size(width), to_size(height));
    gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                 renderbuffers_[0]);
    gl_.bind_renderbuffer(GL_RENDERBUFFER, renderbuffers_[1]);
    gl_.renderbuffer_storage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, to_size(width), to_size(height));
    gl_.framebuffer_renderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER,
                                 renderbuffers_[1]);
    if (gl_.check_framebuffer_status(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        gl_.get_error() != GL_NO_ERROR) {
        fail(width, height);
    }
    // Everything that could make a number into another number is off.
    gl_.disable(GL_DITHER);
    gl_.disable(GL_BLEND);
    gl_.disable(GL_CULL_FACE);
    gl_.shade_model(GL_FLAT);
    gl_.enable(GL_DEPTH_TEST);
    gl_.depth_func(GL_LESS);
    gl_.pixel_storei(GL_PACK_ALIGNMENT, 1);
    gl_.enable_client_state(GL_VERTEX_ARRAY);
    gl_.enable_client_state(GL_COLOR_ARRAY);
}

VisibilityBuffer::~VisibilityBuffer() {
    gl_.delete_framebuffers(1, &framebuffer_);
    gl_.delete_renderbuffers(2, renderbuffers_.data());
}

void VisibilityBuffer::begin(const SampleRect& rect) {
    rect_ = rect;
    pending_.clear();
    stencil_value_ = 0;
    gl_.viewport(0, 0, to_size(rect.width), to_size(rect.height));
    gl_.clear_color(0, 0, 0, 0);
    gl_.clear_depth(1.0);
    gl_.clear_stencil(0);
    gl_.disable(GL_STENCIL_TEST);
    gl_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
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
    gl_.vertex_pointer(4, GL_FLOAT, sizeof(Vertex), pending_.front().position.data());
    gl_.color_pointer(4, GL_UNSIGNED_BYTE, sizeof(Vertex), pending_.front().id.data());
    gl_.draw_arrays(GL_TRIANGLES, 0, static_cast<GLsizei>(pending_.size()));
    pending_.clear();
}

void VisibilityBuffer::draw(std::span<const ScreenPoint> polygon, SurfaceId id) {
    if (is_outside(polygon)) return;
    append_fan(polygon, id);
    if (pending_.size() >= kBatch) flush();
}

void VisibilityBuffer::next_stencil_value() {
    if (stencil_value_ == kLastStencilValue) {
        gl_.clear(GL_STENCIL_BUFFER_BIT);
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
    gl_.enable(GL_STENCIL_TEST);

    // The masks, into the stencil buffer only, whatever lies before them.
    gl_.color_mask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    gl_.disable(GL_DEPTH_TEST);
    gl_.stencil_func(GL_ALWAYS, stencil_value_, 0xFF);
    gl_.stencil_op(GL_KEEP, GL_KEEP, GL_REPLACE);
    for (const auto& mask : masks) {
        if (!is_outside(mask)) append_fan(mask, id);
    }
    flush();

    // The facet itself, where the stencil was not set.
    gl_.color_mask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.enable(GL_DEPTH_TEST);
    gl_.stencil_func(GL_NOTEQUAL, stencil_value_, 0xFF);
    gl_.stencil_op(GL_KEEP, GL_KEEP, GL_KEEP);
    append_fan(polygon, id);
    flush();
    gl_.disable(GL_STENCIL_TEST);
}

void VisibilityBuffer::read(std::vector<SurfaceId>& ids) {
    flush();
    const std::size_t count = std::size_t{rect_.width} * rect_.height;
    std::vector<std::uint8_t> bytes(4 * count);
    gl_.read_pixels(0, 0, to_size(rect_.width), to_size(rect_.height), GL_RGBA, GL_UNSIGNED_BYTE,
                    bytes.data());
    if (gl_.get_error() != GL_NO_ERROR) {
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
