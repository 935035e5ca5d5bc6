// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces for formats whose polygons have no holes.
#pragma once

#include "ncsim/cda/boundary.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ncsim::exporter {

/// What the readers of a format know to draw.
enum class Polygons {
    /// Readers cut others into fans from a corner: a face that is not convex (but for rounding), or
    /// has a corner that is nearly none, is given as triangles.
    Convex,
    /// Readers draw concave ones too, but not where the outline touches itself. Such faces, and
    /// those with holes, are given as triangles.
    Simple
};

/// Each face of a boundary as polygons without holes.
class Pieces {
public:
    /// `boundary` must outlive the pieces.
    Pieces(const cda::Boundary& boundary, Polygons polygons);

    /// Those of the boundary, and a few more that triangulate() made.
    const std::vector<cda::Vec3>& vertices() const { return vertices_; }

    std::size_t count(std::uint32_t face) const;
    /// Vertices of piece `i` of the face, counter-clockwise seen from outside.
    std::span<const std::uint32_t> corners(std::uint32_t face, std::size_t i) const;

private:
    const cda::Boundary& boundary_;
    std::vector<cda::Vec3> vertices_;
    // For each face where in `pieces_` its own begin; none: the face is its outline.
    std::vector<std::uint32_t> first_;
    std::vector<std::array<std::uint32_t, 3>> pieces_;
};

}  // namespace ncsim::exporter
