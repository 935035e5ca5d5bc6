// SPDX-License-Identifier: GPL-3.0-or-later
//
// Through a cell of the grid, eight corners of which are in the material or not, the surface goes
// in up to four pieces. Which of its edges belong to which is told by the corners alone, so that
// neighbours agree: on a face with two corners in at a diagonal, each of these has a piece of its
// own beside it.
//
// After Nielson, "Dual Marching Cubes", Visualization 2004.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace ncsim::dexel {

/// Corner i is at (i & 1, i >> 1 & 1, i >> 2 & 1). Edge 4a + j runs along axis a; j has the place
/// along the next axis in its lowest bit, and that along the one after it in the next.
struct CellComponents {
    static constexpr std::uint8_t kNone = 255;

    /// For each edge the number of its piece; kNone: the surface does not cross it.
    std::array<std::uint8_t, 12> of_edge{};
    std::uint8_t count = 0;
};

/// The corner where the edge begins; it ends at corner + (1 << axis).
int first_corner(int edge);
/// Edge from a corner (the lower of its two) along an axis.
int edge_from(int corner, int axis);

/// `inside`: a bit a corner.
const CellComponents& components_of(std::uint8_t inside);

/// Polygons of marching cubes: edges in order, so that they are counter-clockwise seen from out of
/// the material. Where the pieces go through a face at a diagonal, it is as above.
///
/// Lorensen, Cline, "Marching Cubes", SIGGRAPH 1987.
const std::vector<std::vector<std::uint8_t>>& loops_of(std::uint8_t inside);

}  // namespace ncsim::dexel
