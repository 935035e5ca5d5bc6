// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as PLY, for scripts and for scanner software.
// Source: Greg Turk, The PLY Polygon File Format, 1994.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/mesh/provenance.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `mesh`, the triangles of `boundary`, as binary little-endian PLY, in mm, with unrounded
/// coordinates in doubles. Several readers lose or misread faces with more corners. Each face has
/// the properties nc_line and tool (0 for uncut stock) and red, green and blue.
///
/// Guarantees: an empty part gives a valid file. Equal input gives equal bytes.
/// Throws: std::runtime_error if the stream fails.
void write_ply(std::ostream& out, const cda::Boundary& boundary, const TriangleMesh& mesh,
               const mesh::Provenance& provenance);

}  // namespace ncsim::exporter
