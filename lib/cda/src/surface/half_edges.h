// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps 2 to 5 of stitching (stitch.cpp): from pieces of outlines on lines to pairs of half-edges.
// Lines are independent, so threads process them in parallel.
#pragma once

#include "exact/chunks.h"
#include "exact/groups.h"
#include "exact/none.h"
#include "surface/naming.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ncsim::cda {

/// An edge of a face with direction; the face lies on the left. Points, owners and lines are given
/// by number.
struct HalfEdge {
    std::uint32_t tail, head;
    std::uint32_t owner;
    std::uint32_t line : 30;
    std::uint32_t forward : 1;          ///< 1 if directed along the line.
    std::uint32_t is_non_manifold : 1;  ///< 1 if more than two faces meet at the edge.
    std::uint32_t partner = kNone;
    std::uint32_t next = kNone;  ///< Next half-edge of the face; step 6.
};

/// Returns all half-edges in the order of lines, each with a partner, or kNone if there is none.
/// Outside pieces become half-edges as well if inner pieces lie on the same line.
/// Cost: expected O(n log n), mostly O(n), for n pieces.
Chunks<HalfEdge> pair_half_edges(const Naming& names, Groups<Interval> pieces, std::size_t threads);

/// An edge of an owner, tail before head along the line, between consecutive corners of the owner.
struct BorderEdge {
    std::uint32_t line = 0;
    Interval interval;
};

/// Executes only steps 2 and 3. Returns the edges between two points for which `is_wanted` is true,
/// in the order of lines.
std::vector<BorderEdge> find_border_edges(
    const Naming& names, Groups<Interval> pieces,
    const std::function<bool(std::uint32_t, std::uint32_t)>& is_wanted);

}  // namespace ncsim::cda
