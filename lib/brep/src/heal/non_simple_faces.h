// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planes that touch themselves.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// Of planes with a corner on a straight edge of theirs, or two corners in one place, within
/// `near_mm`, or a corner within the widths of both (reader_widths(), at most 1e-4 mm): the edge is
/// divided there, and both corners are one. No more than that is moved, and corners only where
/// planes alone meet, in lines. Looks at these faces. True: something has changed. O(n log n) for n
/// edges that are spread evenly.
bool join_touching_corners(Part& part, const std::vector<std::uint32_t>& faces, double near_mm);

/// Loops of planes that come back to a corner become several, and where these lie beside each other
/// the face becomes several: they are added at the end, and to the shell that has the face. Of each
/// face that was added: which one it was part of.
std::vector<std::uint32_t> split_non_simple_faces(Part& part);

/// Does the outline of a plane go round the loop, which does not cross it?
bool encloses(const Part& part, const Face& face, const Loop& outline, const Loop& loop);

/// Planes with straight edges alone in which readers find a fault: their loops cross, or touch
/// within 2e-7 mm, or go round the wrong way. O(n log n) likewise, and little where faces are
/// convex.
std::vector<std::uint32_t> crossed_planes(const Part& part);

}  // namespace ncsim::brep
