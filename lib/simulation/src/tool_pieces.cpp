// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes bodies of tools for pages.
#include "tool_pieces.h"

#include "ncsim/cda/flat.h"
#include "ncsim/cda/hull.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/toolpath/tool_polytope.h"

#include <utility>

namespace ncsim::simulation {

std::vector<ColouredMesh> tool_pieces(const toolpath::Tool& tool) {
    // Coarse enough for the longest tool.
    constexpr cda::Lattice kLattice{1e-4};
    constexpr toolpath::ToolAccuracy kAccuracy{0.1, toolpath::Side::Circumscribed};
    std::vector<ColouredMesh> pieces;
    for (const toolpath::ToolPiece& piece : tool.pieces) {
        const auto polytope = toolpath::approximate(piece, kLattice, kAccuracy);
        const auto cell = cda::convex_hull(polytope.points_T, kLattice, cda::kStockOrigin);
        if (!cell) continue;
        ColouredMesh body;
        body.colour = {118, 124, 134};
        if (piece.cutting) body.colour = {226, 186, 92};
        body.mesh = cda::triangulate(cda::FlatCda().create(*cell, kLattice)->boundary());
        pieces.push_back(std::move(body));
    }
    return pieces;
}

}  // namespace ncsim::simulation
