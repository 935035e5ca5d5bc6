// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths and bodies as surfaces, drawn into the buffer of the part.
#pragma once

#include "ncsim/export/overlay.h"
#include "ncsim/export/render_options.h"

#include "render/surface.h"
#include "render/visibility.h"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace ncsim::exporter {

/// Projected overlay, drawn tile by tile.
class OverlayArt {
public:
    OverlayArt(const ScreenMap& map, const Overlay& overlay, const RenderOptions& options);

    /// Draws the overlay over the content of `target`. The first call appends the overlay's
    /// surfaces to `surfaces`.
    /// Requires: `surfaces` contains all surfaces of the part.
    void draw(PolygonTarget& target, std::vector<Surface>& surfaces);

private:
    struct Piece {
        std::array<ScreenPoint, 4> corners;
        std::size_t count = 4;    // of corners
        std::size_t surface = 0;  // index into surfaces_
    };
    void add_path(const PathLine& path, std::size_t surface);
    void add_ghost(const Ghost& ghost);
    void add_stroke(const ScreenPoint& a, const ScreenPoint& b, double overhang,
                    std::size_t surface);
    void add_body(const Body& body, const RenderOptions& options);

    const ScreenMap& map_;
    double pixel_;       // samples per pixel, larger in large pictures
    double half_width_;  // half of the width of a line, in samples
    // Towards the eye: a line on a face must be in front of the face over its width.
    Vec3 lift_;
    std::vector<Surface> surfaces_;
    std::vector<Piece> pieces_;
    std::optional<std::size_t> first_;  // index of surfaces_[0] in the table of the picture
};

}  // namespace ncsim::exporter
