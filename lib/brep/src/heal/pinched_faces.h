// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that hang together in points alone.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Makes separate faces of the pieces of a curved face whose loop returns to corners, if each piece
/// has a loop of its own. Where a ball crosses its own path at one depth, the polyhedron connects
/// pieces of the groove in the crossing, but the true pieces have only points in common. Readers
/// accept a loop that returns to one corner, and refuse a loop that returns to two. New faces are
/// added at the end and to the shell of the face.
/// Cost: O(n log n) for n edges.
void split_pinched_faces(Part& part);

}  // namespace ncsim::brep
