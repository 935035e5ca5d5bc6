// SPDX-License-Identifier: GPL-3.0-or-later
//
// The part as binary STL.
#pragma once

#include "ncsim/base/triangle_mesh.h"

#include <cstddef>
#include <iosfwd>
#include <string_view>

namespace ncsim::exporter {

/// Writes `mesh` as binary STL, in mm. Coordinates are the nearest floats (error 2^-24 of the
/// coordinate, 4 nm at 100 mm). Triangles without extent in floats are omitted. If surfaces touch,
/// or are so close that their floats are equal, corners are moved by steps of 2^-23 of the largest
/// coordinate (8 nm at 100 mm), most often by one step; docs/accuracy.md has the bound. `assumed`
/// is Provenance::assumed; the header has room for its first 30 bytes. `threads`: 0 means as many
/// as the machine has.
///
/// Requires: `mesh` is closed: each directed edge occurs once, and its reverse once.
/// Guarantees: a reader that identifies corners by their coordinates sees a closed oriented
///     2-manifold: each directed edge occurs once, its reverse once, and around each corner there
///     is one fan of triangles; no triangle has a repeated corner or zero area. A mesh without
///     triangles gives a valid file. Equal input gives equal bytes, for any number of threads.
/// Throws: std::invalid_argument if `mesh` is not closed; std::runtime_error if there are more than
///     2^32 - 1 triangles, if a coordinate exceeds 2^100, or if the stream fails.
void write_stl(std::ostream& out, const TriangleMesh& mesh, std::size_t threads = 1,
               std::string_view assumed = {});

}  // namespace ncsim::exporter
