// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps 2 to 5 of stitching (stitch.cpp): from pieces of outlines on lines to pairs of half-edges.
// Each line is worked on by itself, so all threads can.
#pragma once

#include "base/none.h"
#include "exact/chunks.h"
#include "exact/groups.h"
#include "surface/naming.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace ncsim::cda {

/// An edge of a face with its direction; the face lies on its left. Points, owners and lines by
/// number.
struct HalfEdge {
    std::uint32_t tail, head;
    std::uint32_t owner;
    std::uint32_t line : 30;
    std::uint32_t forward : 1;  ///< Along the line?
    std::uint32_t crowded : 1;  ///< More than two faces meet here.
    std::uint32_t partner = kNone;
    std::uint32_t next = kNone;  ///< Of the face; step 6.
};

/// All half-edges in the order of their lines, each with its partner; kNone where there is none.
/// Pieces from outside are half-edges, too, where they lie on a line of others. Expected
/// O(n log n), most of it O(n), for n pieces.
Chunks<HalfEdge> pair_half_edges(const Naming& names, Groups<Interval> pieces, std::size_t threads);

/// An edge of an owner, tail before head along its line, from corner to corner of that owner.
struct BorderEdge {
    std::uint32_t line = 0;
    Interval interval;
};

/// Steps 2 and 3 alone: edges that lie between two points for which `is_wanted` holds; in the order
/// of their lines.
std::vector<BorderEdge> find_border_edges(
    const Naming& names, Groups<Interval> pieces,
    const std::function<bool(std::uint32_t, std::uint32_t)>& is_wanted);

}  // namespace ncsim::cda
