// SPDX-License-Identifier: GPL-3.0-or-later
//
// Planes that run out in a point between two arcs.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Planes whose outline a hole touches from inside, in a corner of both, along arcs that bend to
/// one side: readers lay chords through both, which cross near the corner, and may draw nothing.
/// Each becomes two faces on both sides of the shortest line between a corner of the outline and
/// one of the hole that has the plane on both sides; where there is none, from or to the middle of
/// a round edge, which becomes two. Where both have more corners in common, or no line lies in the
/// plane, it stays. New faces and edges are added at the end, the faces to the shell that has
/// the plane. O(n log n) for n edges where nothing touches; where something does, O(n^2) for the
/// edges of the plane each time.
void split_faces_at_tangent_holes(Part& part);

/// Divides arcs of planes near corners in which they run out together with sharper ones, so that
/// the chords of readers do not cross there. OpenCASCADE drew nothing of such a plane at one
/// deflection or another.
void split_arcs_at_cusps(Part& part);

/// True if the loop of a cone touches the circle in which it ends, in one corner. Readers find such
/// a loop crossed there, as a rule.
bool touches_base_circle(const Part& part, const Face& face);
/// True if split_cones_at_base_circle() divides the face, which touches_base_circle().
bool can_split_on_generator(const Part& part, const Face& face);
/// Makes two faces of each such cone, along a generator from that circle to another edge.
void split_cones_at_base_circle(Part& part);

}  // namespace ncsim::brep
