// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which surface is seen at each sample of a part of the picture: drawn by OpenGL with
// depth and stencil buffer, numbers in place of colours.
#pragma once

#include "ncsim/cda/vec.h"
#include "ncsim/export/camera.h"

#include "render/offscreen.h"
#include "render/surface.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// A rectangle of samples of the whole picture, which may reach beyond it; y downwards.
struct SampleRect {
    std::int64_t x = 0, y = 0;
    std::uint32_t width = 0, height = 0;
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

/// Draws convex polygons into one rectangle at a time and hands back what is seen.
class VisibilityBuffer {
public:
    /// For rectangles of up to width × height samples. Throws std::runtime_error if there is no
    /// OpenGL, or none that can do this size.
    VisibilityBuffer(std::uint32_t width, std::uint32_t height);
    ~VisibilityBuffer();
    VisibilityBuffer(const VisibilityBuffer&) = delete;
    VisibilityBuffer& operator=(const VisibilityBuffer&) = delete;

    /// Clears, and sets where the following polygons are drawn.
    void begin(const SampleRect& rect);
    /// Draws the polygon with its number where it is nearer than what is there.
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id);
    /// The same, but only where none of `masks` is.
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
              std::span<const std::vector<ScreenPoint>> masks);
    /// The numbers seen, row by row from the top. Ends what `begin` began.
    void read(std::vector<SurfaceId>& ids);

private:
    struct Vertex {
        std::array<float, 4> position;
        std::array<std::uint8_t, 4> id;
    };
    void append_fan(std::span<const ScreenPoint> polygon, SurfaceId id);
    bool is_outside(std::span<const ScreenPoint> polygon) const;
    void flush();
    void next_stencil_value();

    OffscreenContext context_;
    const Gl& gl_;
    std::uint32_t width_, height_;
    std::uint32_t framebuffer_ = 0;
    std::array<std::uint32_t, 2> renderbuffers_{};
    SampleRect rect_;
    std::vector<Vertex> pending_;  // triangles without masks, drawn in one go
    std::int32_t stencil_value_ = 0;
};

}  // namespace ncsim::exporter
