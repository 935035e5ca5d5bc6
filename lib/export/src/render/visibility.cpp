// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stencil buffer of Schüppel 2001, section 5.1, with a change: the masks of each facet are
// written with a number of their own. So the buffer need not be cleared after each facet, and a
// mask that extends beyond the edge of its facet by rounding does not affect the next facet.
#include "render/visibility.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ncsim::exporter {

namespace {

// Smallest sine of the angle between a visible face and the line of sight.
constexpr double kGrazing = 1e-6;

// Parts of a cell to which corners are rounded.
constexpr std::int64_t kUnit = 256;
// Distance in cells at which polygons are clipped, so products of two differences fit in 64 bits.
constexpr double kFarthest = 1 << 22;
// Depths from -1 to 1 become whole numbers from -kDepthScale to kDepthScale.
constexpr double kDepthScale = 1 << 23;
constexpr std::int32_t kNothing = std::numeric_limits<std::int32_t>::max();

std::int64_t divide_up(std::int64_t a, std::int64_t b) {
    const std::int64_t q = a / b;
    return q * b < a ? q + 1 : q;
}

// Clips the polygon to the half-space in which the linear function `height` is not negative.
template <class Height>
void clip(std::vector<ScreenPoint>& polygon, const Height& height) {
    if (std::ranges::all_of(polygon, [&](const ScreenPoint& p) { return height(p) >= 0.0; }))
        return;
    std::vector<ScreenPoint> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const ScreenPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double from = height(a), to = height(b);
        if (from >= 0.0) kept.push_back(a);
        if ((from < 0.0) == (to < 0.0)) continue;
        const double t = from / (from - to);
        kept.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.z + t * (b.z - a.z),
                        a.w + t * (b.w - a.w)});
    }
    polygon = std::move(kept);
}

}  // namespace

ScreenMap::ScreenMap(const Camera& camera, double width, double height)
    : camera_(camera), width_(width), height_(height) {}

Vec3 ScreenMap::direction_in_camera(Vec3 v_W) const {
    return {dot(camera_.right, v_W), dot(camera_.up, v_W), dot(camera_.back, v_W)};
}

Vec3 ScreenMap::point_in_camera(Vec3 p_W) const {
    return direction_in_camera(p_W - camera_.target);
}

ScreenPoint ScreenMap::operator()(Vec3 p_W) const {
    const Vec3 p_C = point_in_camera(p_W);
    const double samples_per_mm = height_ / camera_.height;
    const double range = camera_.depth;
    if (camera_.is_orthographic()) {
        return {0.5 * width_ + samples_per_mm * p_C.x, 0.5 * height_ - samples_per_mm * p_C.y,
                -p_C.z / range, 1.0};
    }
    // The eye is at z = d; sizes shrink by d / (d - z). Depth is linear in 1 / w, -1 at z = range
    // and 1 at z = -range, as graphics hardware interpolates depth.
    const double d = camera_.distance;
    const double w = (d - p_C.z) / d;
    const double near = (d - range) / d;
    const double far = (d + range) / d;
    return {0.5 * width_ * w + samples_per_mm * p_C.x, 0.5 * height_ * w - samples_per_mm * p_C.y,
            ((far + near) * w - 2.0 * far * near) / (far - near), w};
}

Vec3 ScreenMap::point_at(double x, double y, double depth) const {
    const double scale = camera_.is_orthographic() ? 1.0 : 1.0 - depth / camera_.distance;
    return {scale * x, scale * y, depth};
}

double ScreenMap::depth_of(Vec3 n_C, double offset, double x, double y) const {
    if (camera_.is_orthographic()) return (offset - n_C.x * x - n_C.y * y) / n_C.z;
    const double d = camera_.distance;
    const double s = (n_C.z * d - offset) / (n_C.z * d - n_C.x * x - n_C.y * y);
    return d * (1.0 - s);
}

bool faces_camera(const Camera& camera, Vec3 normal, Vec3 point) {
    const Vec3 towards_eye =
        camera.is_orthographic()
            ? camera.back
            : normalized(camera.target + camera.distance * camera.back - point);
    return dot(normal, towards_eye) > kGrazing;
}

void VisibilityBuffer::begin(const SampleRect& rect) {
    rect_ = rect;
    size_ = std::size_t{rect.width} * rect.height;
    left_ = kUnit * rect.x / rect.cell;
    top_ = kUnit * rect.y / rect.cell;
    if (ids_.size() < size_) {
        ids_.resize(size_);
        depths_.resize(size_);
    }
    std::fill_n(ids_.begin(), size_, kBackground);
    std::fill_n(depths_.begin(), size_, kNothing);
    stencil_.clear();
    peeled_.clear();
    facets_with_masks_ = 0;
}

void VisibilityBuffer::peel(SurfaceId last) {
    if (peeled_.empty()) peeled_.assign(size_, -kNothing);
    for (std::size_t i = 0; i < size_; ++i) {
        if (ids_[i] != kBackground && ids_[i] <= last) peeled_[i] = depths_[i];
    }
    std::fill_n(ids_.begin(), size_, kBackground);
    std::fill_n(depths_.begin(), size_, kNothing);
    stencil_.clear();
    facets_with_masks_ = 0;
}

// Sets corners_ to the corners of the polygon. Returns false if the polygon is outside the
// rectangle.
bool VisibilityBuffer::place(std::span<const ScreenPoint> polygon) {
    // The eye is at w = 0.
    constexpr double kNearest = 1e-6;
    const double cell = rect_.cell;
    const bool is_far = std::ranges::any_of(polygon, [&](const ScreenPoint& p) {
        return p.w < kNearest || std::abs(p.x) > kFarthest * cell * p.w ||
               std::abs(p.y) > kFarthest * cell * p.w || std::abs(p.z) > p.w;
    });
    if (is_far) {
        clipped_.assign(polygon.begin(), polygon.end());
        clip(clipped_, [](const ScreenPoint& p) { return p.w - kNearest; });
        clip(clipped_, [](const ScreenPoint& p) { return p.z + p.w; });
        clip(clipped_, [](const ScreenPoint& p) { return p.w - p.z; });
        for (const double sign : {-1.0, 1.0}) {
            clip(clipped_,
                 [&](const ScreenPoint& p) { return kFarthest * cell * p.w + sign * p.x; });
            clip(clipped_,
                 [&](const ScreenPoint& p) { return kFarthest * cell * p.w + sign * p.y; });
        }
        polygon = clipped_;
    }
    if (polygon.size() < 3) return false;
    corners_.clear();
    std::int64_t left = std::numeric_limits<std::int64_t>::max(), right = -left;
    std::int64_t top = left, bottom = right;
    for (const ScreenPoint& p : polygon) {
        const double x = p.x / p.w / cell, y = p.y / p.w / cell;
        const Corner corner{std::llround(static_cast<double>(kUnit) * x) - left_,
                            std::llround(static_cast<double>(kUnit) * y) - top_, x, y, p.z / p.w};
        left = std::min(left, corner.x);
        right = std::max(right, corner.x);
        top = std::min(top, corner.y);
        bottom = std::max(bottom, corner.y);
        corners_.push_back(corner);
    }
    return right > 0 && bottom > 0 && left < kUnit * std::int64_t{rect_.width} &&
           top < kUnit * std::int64_t{rect_.height};
}

// Returns the depth of the polygon, computed from the largest of the triangles with the first
// corner.
VisibilityBuffer::Depth VisibilityBuffer::depth() const {
    const Corner& a = corners_.front();
    const auto area = [&](const Corner& b, const Corner& c) {
        return (b.exact_x - a.exact_x) * (c.exact_y - a.exact_y) -
               (c.exact_x - a.exact_x) * (b.exact_y - a.exact_y);
    };
    std::size_t best = 2;
    for (std::size_t i = 3; i < corners_.size(); ++i) {
        if (std::abs(area(corners_[i - 1], corners_[i])) >
            std::abs(area(corners_[best - 1], corners_[best])))
            best = i;
    }
    const Corner &b = corners_[best - 1], &c = corners_[best];
    const double twice = area(b, c);
    Depth depth;
    if (twice != 0.0) {
        const double to_b = b.z - a.z, to_c = c.z - a.z;
        depth.along_x = (to_b * (c.exact_y - a.exact_y) - to_c * (b.exact_y - a.exact_y)) / twice;
        depth.along_y = (to_c * (b.exact_x - a.exact_x) - to_b * (c.exact_x - a.exact_x)) / twice;
    }
    depth.at_origin = a.z + depth.along_x * (0.5 - a.exact_x) + depth.along_y * (0.5 - a.exact_y);
    depth.least = depth.most = a.z;
    for (const Corner& corner : corners_) {
        depth.least = std::min(depth.least, corner.z);
        depth.most = std::max(depth.most, corner.z);
    }
    for (double* value :
         {&depth.at_origin, &depth.along_x, &depth.along_y, &depth.least, &depth.most})
        *value *= kDepthScale;
    return depth;
}

// Returns the cells of the row whose centres are within the polygon: from the leftmost to the
// rightmost crossing of its edges with the line through the centres.
VisibilityBuffer::Run VisibilityBuffer::run(std::uint32_t row) const {
    const std::int64_t y = kUnit * std::int64_t{row} + kUnit / 2;
    std::int64_t begin = std::numeric_limits<std::int64_t>::max(), end = -begin;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const Corner *a = &corners_[i], *b = &corners_[i + 1 == corners_.size() ? 0 : i + 1];
        if ((a->y <= y) == (b->y <= y)) continue;
        if (a->y > b->y) std::swap(a, b);
        // The first centre that is not on the left of the edge.
        const std::int64_t dy = b->y - a->y;
        const std::int64_t at =
            divide_up((a->x - kUnit / 2) * dy + (y - a->y) * (b->x - a->x), kUnit * dy);
        begin = std::min(begin, at);
        end = std::max(end, at);
    }
    begin = std::max<std::int64_t>(begin, 0);
    end = std::min<std::int64_t>(end, rect_.width);
    if (begin >= end) return {};
    return {static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

template <class Draw>
void VisibilityBuffer::for_each_run(const Draw& draw) const {
    const auto [low, high] = std::ranges::minmax(corners_, {}, &Corner::y);
    const std::int64_t first = std::max<std::int64_t>(0, divide_up(low.y - kUnit / 2, kUnit));
    const std::int64_t end =
        std::min<std::int64_t>(rect_.height, divide_up(high.y - kUnit / 2, kUnit));
    for (std::int64_t row = first; row < end; ++row) {
        const Run cells = run(static_cast<std::uint32_t>(row));
        if (cells.begin < cells.end) draw(static_cast<std::uint32_t>(row), cells);
    }
}

// Draws the polygon of corners_; if `is_masked`, not where the latest masks are.
void VisibilityBuffer::fill(const Depth& depth, SurfaceId id, bool is_masked) {
    const bool is_peeled = !peeled_.empty();
    const double first_column = static_cast<double>(left_) / static_cast<double>(kUnit);
    const double first_row = static_cast<double>(top_) / static_cast<double>(kUnit);
    for_each_run([&](std::uint32_t row, Run cells) {
        const double at_row = depth.at_origin + depth.along_y * (first_row + row);
        const std::size_t begin = std::size_t{row} * rect_.width;
        for (std::uint32_t column = cells.begin; column < cells.end; ++column) {
            const double z = std::clamp(at_row + depth.along_x * (first_column + column),
                                        depth.least, depth.most);
            const auto rounded = static_cast<std::int32_t>(z);
            const std::size_t i = begin + column;
            if (rounded >= depths_[i] || (is_masked && stencil_[i] == facets_with_masks_) ||
                (is_peeled && rounded <= peeled_[i]))
                continue;
            depths_[i] = rounded;
            ids_[i] = id;
        }
    });
}

void VisibilityBuffer::draw(std::span<const ScreenPoint> polygon, SurfaceId id) {
    if (place(polygon)) fill(depth(), id, false);
}

void VisibilityBuffer::draw(std::span<const ScreenPoint> polygon, SurfaceId id,
                            std::span<const std::vector<ScreenPoint>> masks) {
    if (masks.empty()) return draw(polygon, id);
    if (!place(polygon)) return;
    if (stencil_.empty()) stencil_.assign(size_, 0);
    ++facets_with_masks_;
    for (const std::vector<ScreenPoint>& mask : masks) {
        if (!place(mask)) continue;
        for_each_run([&](std::uint32_t row, Run cells) {
            const auto begin =
                stencil_.begin() + static_cast<std::ptrdiff_t>(std::size_t{row} * rect_.width);
            std::fill(begin + cells.begin, begin + cells.end, facets_with_masks_);
        });
    }
    if (place(polygon)) fill(depth(), id, true);
}

}  // namespace ncsim::exporter
