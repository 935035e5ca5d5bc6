// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as binary STL, which everything reads.
#pragma once

#include "ncsim/cda/mesh.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `mesh` as binary STL, in millimetres. A vertex has the same three floats in each of its
/// triangles, so a closed mesh stays closed. Triangles two corners of which fall together in floats
/// are left out, and so are two triangles that then lie back to back: what is left is
/// still closed, since their edges cancel out. Corners without an edge between them never fall
/// together: where surfaces touch, one moves on to the next float, so that each edge stands once in
/// each direction for readers that know corners by their coordinates. Nothing moves by more than
/// rounding to floats (2^-24 of the coordinate, 4 nm at 100 mm) and as many floats as surfaces
/// touch.
///
/// A mesh without triangles gives a valid file. Equal input gives equal bytes. Throws
/// std::runtime_error if the mesh has more triangles than the format can count (2^32 - 1), or
/// the stream fails.
void write_stl(std::ostream& out, const cda::TriangleMesh& mesh);

}  // namespace ncsim::exporter
