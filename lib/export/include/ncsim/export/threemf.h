// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as 3MF, for printing and for machines that read it. 3MF Consortium, 3MF Core
// Specification and Reference Guide, version 1.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/cda/mesh.h"
#include "ncsim/export/provenance.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `boundary` as 3MF: one object of triangles, in millimetres and with every digit, with a
/// material for uncut stock and one for each tool (T1, T2, …). Vertices are shared, so the
/// mesh is as closed as the boundary is.
///
/// A part of which nothing is left gives a valid file with an empty build. Equal input gives equal
/// bytes: the archive's times are those of 1980. Throws std::runtime_error if the file would
/// exceed the 4 GiB of a plain ZIP archive, or the stream fails.
void write_3mf(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance);

/// The same for a boundary that is cut into triangles already. Requires: `mesh` is
/// cda::triangulate(boundary).
void write_3mf(std::ostream& out, const cda::Boundary& boundary, const cda::TriangleMesh& mesh,
               const Provenance& provenance);

}  // namespace ncsim::exporter
