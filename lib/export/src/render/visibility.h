// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which surface is seen at each sample of a part of the picture: polygons drawn with a depth buffer
// and a stencil buffer, numbers in place of colours.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/export/camera.h"

#include "render/surface.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// A grid of points of the whole picture, which may reach beyond it; y downwards. Lengths are in
/// samples of the picture.
struct SampleRect {
    std::int64_t x = 0, y = 0;            ///< Upper left corner of the upper left cell.
    std::uint32_t width = 0, height = 0;  ///< In cells.
    std::uint32_t cell = 1;               ///< Side of a cell, in whose centre the point is.
};

/// A point where the camera sees it: in units of samples of the whole picture (x right, y
/// down), depth from -1 (near) to 1, all three times w; orthographic: w = 1.
struct ScreenPoint {
    double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

/// Maps the workpiece frame to ScreenPoints. Computed in doubles and rounded to floats only
/// relative to the rectangle that is drawn, so that large pictures lose nothing.
class ScreenMap {
public:
    /// `width` and `height` in samples.
    ScreenMap(const Camera& camera, double width, double height);

    ScreenPoint operator()(cda::Vec3 p_W) const;
    const Camera& camera() const { return camera_; }
    cda::Vec3 point_in_camera(cda::Vec3 p_W) const;
    cda::Vec3 direction_in_camera(cda::Vec3 v_W) const;
    /// Edge of a sample in mm, at the target.
    double sample_size() const { return camera_.height / height_; }

private:
    Camera camera_;
    double width_, height_;
};

/// Is a face seen from the front? Not if it is seen more flatly than 1e-6 (a sine): nothing of it
/// would be seen, and its depth could not be computed.
bool faces_camera(const Camera& camera, cda::Vec3 normal, cda::Vec3 point);

/// Receives the convex polygons of a picture with the numbers of their surfaces.
class PolygonTarget {
public:
    virtual ~PolygonTarget() = default;
    /// Draws the polygon with its number where it is nearer than what is there.
    virtual void draw(std::span<const ScreenPoint> polygon, SurfaceId id) = 0;
    /// The same, but only where none of `masks` is.
    virtual void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
                      std::span<const std::vector<ScreenPoint>> masks) = 0;
};

/// PolygonTarget with one rectangle of samples at a time.
class SampleBuffer : public PolygonTarget {
public:
    /// Clears, and sets where the following polygons are drawn. `rect.x` and `rect.y` must be
    /// multiples of half a cell.
    virtual void begin(const SampleRect& rect) = 0;
    /// The numbers seen, row by row from the top. Valid until the next call of begin().
    virtual std::span<const SurfaceId> ids() = 0;
};

/// Draws polygons into one rectangle at a time and keeps what is seen.
///
/// Corners are rounded to 1/256 of a sample, counted from the corner of the picture, and depths to
/// 2^-23 of the camera's range; the rest is exact. A sample on an edge belongs to the polygon on
/// the right of the edge, or below it. Of two polygons at one depth, the first is seen.
///
/// Guarantees: the same numbers on every machine; what a sample sees does not depend on the
/// rectangle.
/// Cost: 8 bytes a sample of the largest rectangle, 12 if there are masks.
class VisibilityBuffer final : public SampleBuffer {
public:
    void begin(const SampleRect& rect) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
              std::span<const std::vector<ScreenPoint>> masks) override;
    std::span<const SurfaceId> ids() override { return {ids_.data(), size_}; }

private:
    // A corner in cells from the corner of the rectangle, in units of kUnit, and as it was.
    struct Corner {
        std::int64_t x = 0, y = 0;
        double exact_x = 0.0, exact_y = 0.0, z = 0.0;
    };
    // Depth in units, linear over the cells: at the middle of the cell (0, 0) of the picture, and
    // its changes along x and y; never beyond those of the corners.
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
    std::size_t size_ = 0;             // of the rectangle, cells
    std::int64_t left_ = 0, top_ = 0;  // of the rectangle, in units
    std::vector<SurfaceId> ids_;
    std::vector<std::int32_t> depths_;
    std::vector<std::uint32_t> stencil_;  // number of the last facet with a mask there
    std::uint32_t facets_with_masks_ = 0;
    std::vector<Corner> corners_;  // of the polygon at hand
    std::vector<ScreenPoint> clipped_;
};

}  // namespace ncsim::exporter
