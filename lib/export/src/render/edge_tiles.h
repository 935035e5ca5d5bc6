// SPDX-License-Identifier: GPL-3.0-or-later
//
// Square tiles of a picture, and a mark for each tile that an edge may cross. Far from edges, one
// sample stands for all samples: only marked tiles are drawn with several samples a pixel.
#pragma once

#include "render/surface.h"
#include "render/visibility.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// Side of a tile in pixels.
inline constexpr std::uint32_t kTilePixels = 16;

/// Marks the tiles that edges of polygons cross or come near.
///
/// Guarantees: a polygon whose edges were all added either covers every sample of an unmarked tile
/// and of the margin around the tile, or none of them.
class EdgeTiles final : public PolygonTarget {
public:
    /// `width` and `height` are those of the picture in pixels. `margin` is the number of samples
    /// around a tile that count as part of the tile.
    EdgeTiles(std::uint32_t width, std::uint32_t height, std::uint32_t samples,
              std::uint32_t margin);

    std::uint32_t columns() const { return columns_; }
    std::uint32_t rows() const { return rows_; }
    /// Returns the number of samples along the side of a tile.
    std::uint32_t side() const { return side_; }
    bool is_marked(std::uint32_t column, std::uint32_t row) const {
        return marks_[std::size_t{row} * columns_ + column] != 0;
    }
    void mark(std::uint32_t column, std::uint32_t row) {
        marks_[std::size_t{row} * columns_ + column] = 1;
    }
    void mark_all();

    void add_edge(const ScreenPoint& a, const ScreenPoint& b);
    /// Adds the edges of the polygon and of its masks.
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id) override;
    void draw(std::span<const ScreenPoint> polygon, SurfaceId id,
              std::span<const std::vector<ScreenPoint>> masks) override;

private:
    void mark_row(double left, double right, std::int64_t row);

    std::uint32_t columns_, rows_, side_;
    double margin_;
    std::vector<std::uint8_t> marks_;
};

}  // namespace ncsim::exporter
