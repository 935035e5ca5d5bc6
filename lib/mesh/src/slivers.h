// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removal of thin triangles, which readers with a tolerance of their own reject.
#pragma once

#include "ncsim/base/triangle_mesh.h"

#include <cstddef>

namespace ncsim::mesh {

/// Removes edges shorter than `least_mm` and triangles lower than `least_mm` from a closed mesh,
/// unless the topology would change. The ends of a short edge become a single vertex; the longest
/// edge of a low triangle is replaced by edges to the opposite vertex. Shells smaller than
/// `least_mm` vanish. If `least_mm` is 0, the mesh stays unchanged. `threads` is for the search for
/// low triangles; 0 means as many as the machine has.
///
/// Requires: the mesh is closed.
/// Returns: true if the mesh changed.
/// Guarantees: the mesh stays closed. A vertex is replaced by a vertex at most 2 `least_mm` away;
///     replaced vertices stay in the list, unused.
/// Cost: O(n log n) expected.
bool remove_slivers(TriangleMesh& mesh, double least_mm, std::size_t threads = 1);

}  // namespace ncsim::mesh
