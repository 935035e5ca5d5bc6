// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planar faces that touch themselves.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Joins corners of planar faces that touch the same face within `near_mm`, or
/// within the widths of corner and edge (reader_widths(), at most 1e-4 mm): divides a straight edge
/// at a corner that lies on the edge, and merges two corners by moving a corner to the second.
/// Divides only edges between planes, and moves only corners at which planes and lines alone meet.
/// Only `faces` are examined.
/// Returns: true if the part changed.
/// Cost: O(n log n) for n evenly distributed edges.
bool join_touching_corners(Part& part, const std::vector<std::uint32_t>& faces, double near_mm);

/// Splits each loop of a planar face that returns to a corner into simple loops. A face with
/// several outlines becomes several faces. New faces are appended to the part, and to the shell of
/// the split face.
/// Returns: for each new face, the number of the face that was split.
std::vector<std::uint32_t> split_non_simple_faces(Part& part);

/// True if `outline` of a planar face surrounds `loop`.
/// Requires: `outline` and `loop` do not cross.
bool encloses(const Part& part, const Face& face, const Loop& outline, const Loop& loop);

/// Returns the planar faces with straight edges only that CAD readers reject, ascending: loops
/// cross, come within 2e-7 mm of each other, or have the wrong orientation.
/// Cost: O(n log n) for n evenly distributed edges; O(n) for convex faces.
std::vector<std::uint32_t> crossed_planes(const Part& part);

}  // namespace ncsim::brep
