// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners between an arc and its chords.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Arcs of planes on whose inner side, nearer than 0.02 mm and than the chord of the arc, a corner
/// of the same plane is become two, with an end where they are nearest to it. Readers draw chords,
/// which would pass on the other side of the corner, and then draw nothing of the plane. Not of
/// splines. New vertices and edges are added at the end. O(n log n) for n edges that are spread
/// evenly.
void divide_arcs_beside_corners(Part& part);

}  // namespace ncsim::brep
