// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces whose pieces have only points in common.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Makes separate faces of the pieces of a curved face whose single loop returns to corners, if
/// each piece is a sound face with a separate loop. If a ball end mill crosses its path at the same
/// depth, the polyhedron connects pieces of the groove at the crossing, but the true pieces have
/// only points in common. CAD readers accept a loop that returns to a single corner, and reject a
/// loop that returns to two. New faces are appended to the part, and to the shell of the face.
/// Cost: O(n log n) for n edges.
void split_pinched_faces(Part& part);

}  // namespace ncsim::brep
