// SPDX-License-Identifier: GPL-3.0-or-later
//
// Components of the surface in a cell of the grid. Each of the eight corners is in the material or
// not, and the surface passes through the cell in up to four pieces. The corners alone determine
// the piece of each edge, so that adjacent cells agree: on a face with two diagonal corners in the
// material, each of the two has a separate piece.
//
// Source: after Nielson, "Dual Marching Cubes", Visualization 2004.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ncsim::dexel {

/// The pieces of the surface in a cell. Corner i is at (i & 1, i >> 1 & 1, i >> 2 & 1). Edge 4a + j
/// runs along axis a; the lowest bit of j is the position along the next axis, the second bit the
/// position along the axis after the next.
struct CellComponents {
    static constexpr std::uint8_t kNone = 255;

    /// Piece of each edge; kNone if the surface does not cross the edge.
    std::array<std::uint8_t, 12> of_edge{};
    std::uint8_t count = 0;
};

/// Returns the corner where the edge begins; the edge ends at corner + (1 << axis).
int first_corner(int edge);
/// Returns the edge from a corner (the lower of its two) along an axis.
int edge_from(int corner, int axis);

/// Returns the components for `inside`, a bit per corner.
const CellComponents& components_of(std::uint8_t inside);

/// Returns the polygons of marching cubes: loops of edges, counter-clockwise seen from outside the
/// material. On faces with diagonal corners the pieces are separated as described above.
/// Source: Lorensen, Cline, "Marching Cubes", SIGGRAPH 1987.
const std::vector<std::vector<std::uint8_t>>& loops_of(std::uint8_t inside);

}  // namespace ncsim::dexel
