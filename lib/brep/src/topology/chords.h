// SPDX-License-Identifier: GPL-3.0-or-later
//
// Corners of planar faces between an arc and the chords of the arc.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Splits arcs of planar faces next to corners. An arc is split if a corner of the same face lies
/// on the arc's inner side, within 0.02 mm of the arc and within twice the depth of the arc's
/// chord. The new vertex is the point of the arc nearest to the corner. CAD readers draw chords; if
/// a chord passes on the wrong side of a corner, CAD readers draw nothing of the face. Splines are
/// not split. New vertices and edges are appended.
/// Cost: O(n log n) for n evenly distributed edges.
void split_arcs_near_corners(Part& part);

}  // namespace ncsim::brep
