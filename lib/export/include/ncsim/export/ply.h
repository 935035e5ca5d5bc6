// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as PLY, for scripts and scanners' software. Greg Turk, The PLY Polygon File Format,
// 1994.
#pragma once

#include "ncsim/cda/boundary.h"
#include "ncsim/export/provenance.h"

#include <iosfwd>

namespace ncsim::exporter {

/// Writes `boundary` as binary little-endian PLY, in millimetres, with coordinates in doubles:
/// nothing is rounded. Convex faces are n-gons, others are cut into triangles. Each face has the
/// properties nc_line and tool (0 for uncut stock) and red, green and blue.
///
/// A part of which nothing is left gives a valid file. Equal input gives equal bytes. Throws
/// std::runtime_error if the stream fails.
void write_ply(std::ostream& out, const cda::Boundary& boundary, const Provenance& provenance);

}  // namespace ncsim::exporter
