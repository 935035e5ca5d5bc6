// SPDX-License-Identifier: GPL-3.0-or-later
//
// Half-edges of a closed surface.
#pragma once

#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <vector>

namespace ncsim::mesh {

/// An edge with the face on the left.
struct HalfEdge {
    std::uint32_t from, to;  ///< Vertices.
    std::uint32_t face;      ///< The face on the left.
};

/// Returns the half-edges of all loops, in the order of the loops.
std::vector<HalfEdge> half_edges(const cda::Boundary& boundary);

/// Returns for each half-edge the index of the opposite half-edge.
/// Requires: the surface is closed.
/// Cost: O(n log n).
std::vector<std::uint32_t> twins_of(const std::vector<HalfEdge>& edges);

}  // namespace ncsim::mesh
