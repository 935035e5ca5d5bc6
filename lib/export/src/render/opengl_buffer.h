// SPDX-License-Identifier: GPL-3.0-or-later
//
// Polygons drawn by OpenGL with a depth and a stencil buffer; the alternative to VisibilityBuffer.
#pragma once

#include "render/offscreen.h"
#include "render/visibility.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// Draws polygons into one rectangle at a time.
/// Throws: every member throws std::runtime_error if OpenGL fails.
class OpenGlBuffer final : public SampleBuffer {
public:
    explicit OpenGlBuffer(std::unique_ptr<OffscreenContext> context);
    ~OpenGlBuffer() override;
    OpenGlBuffer(const OpenGlBuffer&) = delete;
    OpenGlBuffer& operator=(const OpenGlBuffer&) = delete;

    void begin(const SampleRect& rect) override;
    void peel(SurfaceId last) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
              std::span<const std::vector<ScreenPoint>> masks) override;
    std::span<const SurfaceId> ids() override;

private:
    struct Vertex {
        std::array<float, 4> position;
        std::array<std::uint8_t, 4> id;
    };
    void append_fan(std::span<const ScreenPoint> polygon, SurfaceId id);
    void flush();

    void resize();

    std::unique_ptr<OffscreenContext> context_;
    const Gl& gl_;
    SampleRect rect_;
    std::uint32_t width_ = 0, height_ = 0;  // of the framebuffer
    std::uint32_t framebuffer_ = 0;
    std::array<std::uint32_t, 2> renderbuffers_{};
    std::vector<Vertex> pending_;
    std::vector<SurfaceId> ids_;
};

}  // namespace ncsim::exporter
