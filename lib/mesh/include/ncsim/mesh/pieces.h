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

namespace ncsim::mesh {

/// Each face of a boundary as convex polygons, because readers split polygons into fans from a
/// corner. A face that is not convex (except for rounding), that has holes, or that has a nearly
/// straight corner, is given as triangles.
class Pieces {
public:
    /// Requires: `boundary` outlives the pieces.
    explicit Pieces(const cda::Boundary& boundary);

    /// Returns the vertices of the boundary, followed by those that triangulate() added.
    const std::vector<Vec3>& vertices() const { return vertices_; }

    /// Returns the number of pieces of the face.
    std::size_t count(std::uint32_t face) const;
    /// Returns the vertices of piece `i` of the face, counter-clockwise seen from outside.
    std::span<const std::uint32_t> corners(std::uint32_t face, std::size_t i) const;

private:
    const cda::Boundary& boundary_;
    std::vector<Vec3> vertices_;
    // For each face, start of the triangles in `pieces_`; a face without triangles is drawn as
    // outline.
    std::vector<std::uint32_t> first_;
    std::vector<std::array<std::uint32_t, 3>> pieces_;
};

}  // namespace ncsim::mesh
