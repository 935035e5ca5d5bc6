// SPDX-License-Identifier: GPL-3.0-or-later
//
// The edges of a closed surface, each from both sides.
#pragma once

#include "ncsim/cda/boundary.h"

#include <cstdint>
#include <vector>

namespace ncsim::exporter {

struct HalfEdge {
    std::uint32_t from, to;  ///< Vertices.
    std::uint32_t face;      ///< On its left.
};

/// Of all loops, in their order.
std::vector<HalfEdge> half_edges(const cda::Boundary& boundary);

/// For each half-edge, by position, the one in the other direction. Requires a closed surface.
/// O(n log n).
std::vector<std::uint32_t> twins_of(const std::vector<HalfEdge>& edges);

}  // namespace ncsim::exporter
