// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marking of the tiles that edges cross.
#include "render/edge_tiles.h"

#include <algorithm>
#include <cmath>

namespace ncsim::exporter {

namespace {

std::uint32_t tiles_in(std::uint32_t pixels) {
    return (pixels + kTilePixels - 1) / kTilePixels;
}

// Returns the index of the tile at the coordinate `x` (samples), clamped to [-1, count].
std::int64_t tile_at(double x, double side, std::uint32_t count) {
    return static_cast<std::int64_t>(
        std::floor(std::clamp(x / side, -1.0, static_cast<double>(count))));
}

}  // namespace

EdgeTiles::EdgeTiles(std::uint32_t width, std::uint32_t height, std::uint32_t samples,
                     std::uint32_t margin)
    : columns_(tiles_in(width)),
      rows_(tiles_in(height)),
      side_(kTilePixels * samples),
      margin_(margin),
      marks_(std::size_t{columns_} * rows_) {}

void EdgeTiles::mark_all() {
    std::ranges::fill(marks_, std::uint8_t{1});
}

// Marks the tiles of a row that contain a point from `left` to `right` (samples).
void EdgeTiles::mark_row(double left, double right, std::int64_t row) {
    const std::int64_t first = std::max<std::int64_t>(0, tile_at(left, side_, columns_));
    const std::int64_t last =
        std::min<std::int64_t>(std::int64_t{columns_} - 1, tile_at(right, side_, columns_));
    if (first > last) return;
    const auto begin = marks_.begin() + (row * std::int64_t{columns_} + first);
    std::fill(begin, begin + (last - first + 1), std::uint8_t{1});
}

void EdgeTiles::add_edge(const ScreenPoint& a, const ScreenPoint& b) {
    // The projection of an edge that reaches behind the eye can be anywhere.
    if (!(a.w > 0.0) || !(b.w > 0.0)) return mark_all();
    double x = a.x / a.w, y = a.y / a.w, to_x = b.x / b.w, to_y = b.y / b.w;
    if (y > to_y) {
        std::swap(x, to_x);
        std::swap(y, to_y);
    }
    const std::int64_t first = std::max<std::int64_t>(0, tile_at(y - margin_, side_, rows_));
    const std::int64_t last =
        std::min<std::int64_t>(std::int64_t{rows_} - 1, tile_at(to_y + margin_, side_, rows_));
    const double slope = to_y > y ? (to_x - x) / (to_y - y) : 0.0;
    for (std::int64_t row = first; row <= last; ++row) {
        // Clips the edge to the row and its margin.
        const auto top = static_cast<double>(row * side_) - margin_;
        const auto bottom = static_cast<double>((row + 1) * side_) + margin_;
        const double at_top = top > y ? x + slope * (top - y) : x;
        const double at_bottom = bottom < to_y ? x + slope * (bottom - y) : to_x;
        mark_row(std::min(at_top, at_bottom) - margin_, std::max(at_top, at_bottom) + margin_, row);
    }
}

void EdgeTiles::draw(std::span<const ScreenPoint> polygon, SurfaceId /*id*/) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        add_edge(polygon[i], polygon[(i + 1) % polygon.size()]);
}

void EdgeTiles::draw(std::span<const ScreenPoint> polygon, SurfaceId id,
                     std::span<const std::vector<ScreenPoint>> masks) {
    draw(polygon, id);
    for (const std::vector<ScreenPoint>& mask : masks)
        draw(mask, id);
}

}  // namespace ncsim::exporter
