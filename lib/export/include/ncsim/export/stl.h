// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as binary STL, which everything reads.
#pragma once

#include "ncsim/cda/mesh.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `mesh` as binary STL, in millimetres. A vertex has the same three floats in each of its
/// triangles, so a closed mesh stays closed. Triangles that rounding to floats makes degenerate are
/// kept, with a normal of zero: leaving them out would open the mesh.
///
/// A mesh without triangles gives a valid file. Equal input gives equal bytes. Throws
/// std::runtime_error if the mesh has more triangles than the format can count (2^32 - 1), or
/// the stream fails.
void write_stl(std::ostream& out, const cda::TriangleMesh& mesh);

}  // namespace ncsim::exporter
