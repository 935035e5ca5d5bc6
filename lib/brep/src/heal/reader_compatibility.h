// SPDX-License-Identifier: GPL-3.0-or-later
//
// What readers of files need beyond what is true.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Ellipses beside extrusions that go about half around them become two edges. Readers know such a
/// surface by its parameters alone, and of an edge whose ends are half a turn apart not which way
/// it goes. Beside shallow ones they become so many that none goes more than 37 degrees around, and
/// so do splines, as far as they have knots. Edges of spheres that pass near a pole go no more
/// than a quarter around it.
void split_wide_edges(Part& part);

/// Divides the edges of faces between two edges that are at most 0.1 mm apart in the middle.
/// Readers draw chords; if both edges become one chord, readers draw nothing of the face.
void split_edges_of_lenses(Part& part);

}  // namespace ncsim::brep
