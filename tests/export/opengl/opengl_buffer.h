// SPDX-License-Identifier: GPL-3.0-or-later
//
// Oracle for VisibilityBuffer: the same operations by OpenGL with depth and stencil buffer.
#pragma once

#include "opengl/offscreen.h"
#include "render/visibility.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter::test {

/// Draws polygons into a picture of `width` × `height` samples. Throws std::runtime_error if there
/// is no OpenGL.
class OpenGlBuffer final : public PolygonTarget {
public:
    OpenGlBuffer(std::uint32_t width, std::uint32_t height);
    ~OpenGlBuffer() override;
    OpenGlBuffer(const OpenGlBuffer&) = delete;
    OpenGlBuffer& operator=(const OpenGlBuffer&) = delete;

    void draw(std::span<const ScreenPoint> polygon, SurfaceId id) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
              std::span<const std::vector<ScreenPoint>> masks) override;
    /// The numbers seen, row by row from the top.
    std::vector<SurfaceId> read();

private:
    struct Vertex {
        std::array<float, 4> position;
        std::array<std::uint8_t, 4> id;
    };
    void append_fan(std::span<const ScreenPoint> polygon, SurfaceId id);
    void flush();

    OffscreenContext context_;
    const Gl& gl_;
    std::uint32_t width_, height_;
    std::uint32_t framebuffer_ = 0;
    std::array<std::uint32_t, 2> renderbuffers_{};
    std::vector<Vertex> pending_;
};

}  // namespace ncsim::exporter::test
