// SPDX-License-Identifier: GPL-3.0-or-later
//
// Subdivision of correct edges that CAD readers misinterpret.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Halves these edges until none remains, except lines, and splines without an inner knot:
/// - Edges of extrusions, other than circles, whose ends are more than 154 degrees apart about the
///   circle. CAD readers know an extrusion by its parameters only; if the ends of an edge are half
///   a turn apart, the direction of the edge is ambiguous. If the line of the extrusion is at most
///   5.7 degrees off the plane of the circle, the limit is 37 degrees.
/// - Edges of envelopes along which the direction of motion turns by more than 60 degrees.
/// - Edges of spheres that pass near a pole and go more than a quarter of a turn around the pole.
void split_wide_edges(Part& part);

/// Divides both edges of faces with two edges that are at most 0.1 mm apart in the middle; lines
/// stay. CAD readers draw chords; if both edges become the same chord, CAD readers draw nothing of
/// the face.
void split_edges_of_lenses(Part& part);

}  // namespace ncsim::brep
