// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as binary STL, which everything reads.
#pragma once

#include "ncsim/cda/mesh.h"

#include <cstddef>
#include <iosfwd>
#include <string_view>

namespace ncsim::exporter {

/// Writes `mesh` as binary STL, in millimetres. For a reader, who knows corners by their
/// coordinates alone, it is a closed oriented 2-manifold: each directed edge stands once, its
/// reverse once, and around each corner there is one fan of triangles; no triangle has a corner
/// twice or no area. Coordinates are the nearest floats (2^-24 of the coordinate, 4 nm at 100 mm).
/// What has no extent in floats is left out. Where surfaces touch, or lie so near each other that
/// floats cannot tell, corners are moved on by a step of 2^-23 of the largest coordinate (8 nm at
/// 100 mm), most often one; docs/accuracy.md has the bound.
///
/// Requires a closed mesh: each directed edge once, its reverse once. A mesh without triangles
/// gives a valid file. Equal input gives equal bytes, for any number of threads (0: as many as the
/// machine has). Throws std::invalid_argument if the mesh is
/// not closed, std::runtime_error if it has more triangles than the format can count (2^32 - 1) or
/// coordinates beyond 2^100, or the stream fails.
/// `assumed`: as Provenance::assumed; the header has room for the first 30 bytes of it.
void write_stl(std::ostream& out, const cda::TriangleMesh& mesh, std::size_t threads = 1,
               std::string_view assumed = {});

}  // namespace ncsim::exporter
