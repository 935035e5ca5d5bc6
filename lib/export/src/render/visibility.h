// SPDX-License-Identifier: GPL-3.0-or-later
//
// Visible surface at each sample of a part of the picture: polygons drawn with a depth buffer and a
// stencil buffer, with numbers instead of colours.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/export/camera.h"

#include "render/surface.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// A grid of points of the picture, which may extend beyond the picture; y downwards. Lengths are
/// in samples of the picture.
struct SampleRect {
    std::int64_t x = 0, y = 0;            ///< Upper left corner of the upper left cell.
    std::uint32_t width = 0, height = 0;  ///< In cells.
    std::uint32_t cell = 1;  ///< Side of a cell; the point is in the centre of the cell.
};

/// A projected point: x (right) and y (down) in samples of the picture, and depth from -1 (near) to
/// 1, each times w. In an orthographic picture, w = 1.
struct ScreenPoint {
    double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

/// Maps the workpiece frame to ScreenPoints in doubles. Renderers round only relative to the
/// current rectangle, so large pictures lose no accuracy.
class ScreenMap {
public:
    /// `width` and `height` are in samples.
    ScreenMap(const Camera& camera, double width, double height);

    ScreenPoint operator()(Vec3 p_W) const;
    const Camera& camera() const { return camera_; }
    Vec3 point_in_camera(Vec3 p_W) const;
    Vec3 direction_in_camera(Vec3 v_W) const;
    /// Returns the side of a sample in mm, at the target.
    double sample_size() const { return camera_.height / height_; }
    /// Returns the point at (x, y) and `depth` in the camera frame. (x, y) is in mm at the target,
    /// from the centre of the picture.
    Vec3 point_at(double x, double y, double depth) const;
    /// Returns the depth at which the line of sight through (x, y) meets the plane n_C · p =
    /// offset: z in the camera frame. (x, y) is as for point_at().
    double depth_of(Vec3 n_C, double offset, double x, double y) const;

private:
    Camera camera_;
    double width_, height_;
};

/// True if a face is seen from the front, at an angle whose sine exceeds 1e-6. Flatter faces are
/// invisible, and their depth cannot be computed.
bool faces_camera(const Camera& camera, Vec3 normal, Vec3 point);

/// Receives the convex polygons of a picture with the numbers of their surfaces.
class PolygonTarget {
public:
    virtual ~PolygonTarget() = default;
    /// Draws the polygon where it is nearer than the present content.
    virtual void draw(std::span<const ScreenPoint> polygon, SurfaceId id) = 0;
    /// Draws the polygon where it is nearer than the present content and no mask covers it.
    virtual void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
                      std::span<const std::vector<ScreenPoint>> masks) = 0;
};

/// PolygonTarget with one rectangle of samples at a time.
class SampleBuffer : public PolygonTarget {
public:
    /// Clears the buffer and sets the rectangle for the following polygons.
    /// Requires: `rect.x` and `rect.y` are multiples of half a cell.
    virtual void begin(const SampleRect& rect) = 0;
    /// Clears the buffer after drawing. Where the content was a number up to `last`, only polygons
    /// behind this content are drawn from then on.
    /// Throws: std::runtime_error if the buffer does not support this.
    virtual void peel(SurfaceId last) = 0;
    /// Returns the visible numbers, row by row from the top. Valid until the next call of begin().
    virtual std::span<const SurfaceId> ids() = 0;
};

/// Draws polygons into one rectangle at a time and keeps the visible surfaces.
///
/// Corners are rounded to 1/256 of a cell, counted from the corner of the picture, and depths to
/// 2^-23 of the camera's depth; all further steps are exact. A sample on an edge belongs to the
/// polygon to the right of the edge, or below it. If two polygons have the same depth, the first is
/// visible.
///
/// Guarantees: the same numbers on every machine. For a given size of cells, the number at a sample
///     does not depend on the rectangle.
/// Cost: 8 bytes a sample of the largest rectangle; 4 more with masks, and 4 after peel().
class VisibilityBuffer final : public SampleBuffer {
public:
    void begin(const SampleRect& rect) override;
    void peel(SurfaceId last) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
              std::span<const std::vector<ScreenPoint>> masks) override;
    std::span<const SurfaceId> ids() override { return {ids_.data(), size_}; }

private:
    // A corner relative to the corner of the rectangle, in units of 1 / kUnit of a cell, and its
    // exact coordinates in cells of the picture.
    struct Corner {
        std::int64_t x = 0, y = 0;
        double exact_x = 0.0, exact_y = 0.0, z = 0.0;
    };
    // Linear depth in units of 1 / kDepthScale: at the centre of cell (0, 0) of the picture, its
    // changes along x and y, and its range over the corners, which bounds the depth.
    struct Depth {
        double at_origin = 0.0, along_x = 0.0, along_y = 0.0;
        double least = 0.0, most = 0.0;
    };
    // Cells of a row.
    struct Run {
        std::uint32_t begin = 0, end = 0;
    };
    bool place(std::span<const ScreenPoint> polygon);
    Depth depth() const;
    Run run(std::uint32_t row) const;
    template <class Draw>
    void for_each_run(const Draw& draw) const;
    void fill(const Depth& depth, SurfaceId id, bool is_masked);

    SampleRect rect_;
    std::size_t size_ = 0;             // cells of the rectangle
    std::int64_t left_ = 0, top_ = 0;  // corner of the rectangle, in 1 / kUnit of a cell
    std::vector<SurfaceId> ids_;
    std::vector<std::int32_t> depths_;
    std::vector<std::int32_t> peeled_;    // depths of the peeled content; empty: none
    std::vector<std::uint32_t> stencil_;  // number of the latest facet with a mask there
    std::uint32_t facets_with_masks_ = 0;
    std::vector<Corner> corners_;  // of the current polygon
    std::vector<ScreenPoint> clipped_;
};

}  // namespace ncsim::exporter
