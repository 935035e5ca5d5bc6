// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as 3MF, for printing and for machines that read 3MF.
// Source: 3MF Consortium, 3MF Core Specification and Reference Guide, version 1.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/triangulate.h"
#include "ncsim/mesh/provenance.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `boundary` as 3MF: one object of triangles, in mm and with all digits, with a material
/// for uncut stock and a material for each tool (T1, T2, …). Vertices are shared, so the mesh is
/// closed if the boundary is.
///
/// Guarantees: an empty part gives a valid file with an empty build. Equal input gives equal bytes;
///     the times in the archive are those of 1980.
/// Throws: std::runtime_error if the file would exceed the 4 GiB of a plain ZIP archive, or if the
///     stream fails.
void write_3mf(std::ostream& out, const cda::Boundary& boundary,
               const mesh::Provenance& provenance);

/// Writes a boundary that is already split into triangles.
/// Requires: `mesh` is cda::triangulate(boundary).
void write_3mf(std::ostream& out, const cda::Boundary& boundary, const TriangleMesh& mesh,
               const mesh::Provenance& provenance);

}  // namespace ncsim::exporter
