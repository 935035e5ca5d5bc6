// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faces that narrow to a cusp between two tangent curves.
#pragma once

#include "ncsim/brep/part.h"

namespace ncsim::brep {

/// Splits planar faces with a hole that touches the outline from inside, in a common corner, along
/// arcs that bend to the same side. CAD readers replace both arcs by chords, which cross near the
/// corner, and may draw nothing of the face. The face is divided into two along the shortest line
/// inside the face between a corner of the outline and a corner of the hole. If there is no such
/// line, curved edges are halved, and the line starts or ends in the middle of a curved edge. The
/// face stays if outline and hole have more than one common corner, or if no line lies inside the
/// face. New faces and edges are appended to the part, new faces to the shell of the split face.
/// Cost: O(n log n) for n edges if no hole touches; otherwise O(m²) with each split of a face of m
/// edges.
void split_faces_at_tangent_holes(Part& part);

/// Divides arcs of planar faces near corners at which the arc is tangent to an arc of smaller
/// radius that bends to the same side. Otherwise the chords of CAD readers may cross there;
/// OpenCASCADE drew nothing of such a face at some deflections.
void split_arcs_at_cusps(Part& part);

/// True if the loop of a conical face contains the closed base circle, which the rest of the loop
/// touches in a corner. CAD readers usually report that such a loop crosses itself.
bool touches_base_circle(const Part& part, const Face& face);
/// True if split_cones_at_base_circle() can divide the face.
/// Requires: touches_base_circle().
bool can_split_on_generator(const Part& part, const Face& face);
/// Divides each conical face for which touches_base_circle() is true into two faces, along a
/// generator from the base circle to the middle of another edge. Faces for which
/// can_split_on_generator() is false stay.
void split_cones_at_base_circle(Part& part);

}  // namespace ncsim::brep
