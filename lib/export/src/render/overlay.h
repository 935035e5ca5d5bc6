// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paths and bodies as surfaces, drawn into the same buffer as the part.
#pragma once

#include "ncsim/export/overlay.h"
#include "ncsim/export/render_options.h"

#include "render/surface.h"
#include "render/visibility.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// An overlay, ready to be drawn tile by tile.
class OverlayArt {
public:
    OverlayArt(const ScreenMap& map, const Overlay& overlay, const RenderOptions& options);

    /// Draws everything over what is in `target`. The first call appends its surfaces to
    /// `surfaces`, which must hold all those of the part by then.
    void draw(PolygonTarget& target, std::vector<Surface>& surfaces);

private:
    struct Piece {
        std::array<ScreenPoint, 4> corners;
        std::size_t count = 4;    // of corners
        std::size_t surface = 0;  // in surfaces_
    };
    void add_path(const PathLine& path, std::size_t surface);
    void add_ghost(const Ghost& ghost);
    void add_stroke(const ScreenPoint& a, const ScreenPoint& b, double overhang,
                    std::size_t surface);
    void add_body(const Body& body);

    const ScreenMap& map_;
    double pixel_;       // samples
    double half_width_;  // of a line, in samples
    cda::Vec3 lift_;     // towards the eye: a line on a face lies before it all over its width
    std::vector<Surface> surfaces_;
    std::vector<Piece> pieces_;
    std::optional<std::size_t> first_;  // number of surfaces_[0] in the table of the picture
};

}  // namespace ncsim::exporter
