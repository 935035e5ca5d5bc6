// SPDX-License-Identifier: GPL-3.0-or-later
//
// Darker light in recesses: a depth cue for pockets and holes, also where they are seen along their
// axes.
#pragma once

#include "ncsim/base/vec3.h"
#include "ncsim/export/render_options.h"

#include "render/pixel_rect.h"
#include "render/surface.h"
#include "render/visibility.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// Ambient occlusion in the picture. The brightness of a point decreases with the mean height of
/// the visible part around the point above the tangent plane of the point. No point of a convex
/// part is darker.
///
/// Guarantees: the same brightness on every machine.
/// Cost: some 130 bytes for each of at most some 80,000 cells.
class RecessShade {
public:
    RecessShade(const ScreenMap& map, const RenderOptions& options);

    /// Cells in which the scene is to be drawn for gather().
    const SampleRect& cells() const { return cells_; }
    /// Takes the surfaces seen in cells().
    void gather(std::span<const SurfaceId> ids, const std::vector<Surface>& surfaces);

    /// Sets the tile of the functions below.
    void begin(const PixelRect& tile);
    /// Returns the brightness from 0 to 1 (sRGB) in the middle of pixel (x, y) of the picture, of a
    /// point on the plane n_C · p = offset.
    float brightness(Vec3 n_C, double offset, std::uint32_t x, std::uint32_t y) const;
    /// Returns the brightness of `count` pixels of the tile, from (x, y) to the right, on a flat
    /// surface. Valid until the next call.
    std::span<const float> brightness(SurfaceId id, const Surface& surface, std::uint32_t x,
                                      std::uint32_t y, std::uint32_t count);
    /// True if the surface is darker at some pixel of the tile.
    bool is_darker(SurfaceId id, const Surface& surface);

private:
    // Weighted sum of the points around a cell, in the camera frame, and of their weights. The
    // factors make heights relative to the radius of the sum.
    struct Sum {
        double x = 0, y = 0, z = 0, weight = 0;

        double height_above(Vec3 n_C, double offset) const {
            return n_C.x * x + n_C.y * y + n_C.z * z - offset * weight;
        }
    };
    // Position of the middle of a pixel between the centres of cells: the cell before, and the
    // share of the next cell.
    struct Place {
        std::uint32_t cell = 0;
        double share = 0;
    };
    // Heights in the cells of the tile above the plane of a surface.
    struct Plane {
        SurfaceId id = kBackground;
        bool is_darker = false;
        std::vector<double> heights;
    };
    std::vector<Place> places(std::uint32_t pixels) const;
    const Plane& plane(SurfaceId id, const Surface& surface);

    ScreenMap map_;
    double samples_wide_, samples_high_;  // of the picture
    std::uint32_t samples_;               // along the side of a pixel
    SampleRect cells_;
    std::vector<Place> columns_, rows_;  // by pixel
    std::vector<Sum> sums_;
    // Cells of the tile.
    std::uint32_t first_column_ = 0, first_row_ = 0, tile_columns_ = 0, tile_rows_ = 0;
    std::vector<Plane> planes_;  // of the tile; those from count_ on are unused
    std::size_t count_ = 0, latest_ = 0;
    std::vector<double> in_row_;  // heights of the latest row of pixels
    std::vector<float> brightness_;
};

}  // namespace ncsim::exporter
