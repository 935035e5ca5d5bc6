// SPDX-License-Identifier: GPL-3.0-or-later
//
// A surface without the thin triangles that readers with a tolerance of their own stumble over.
#pragma once

#include "ncsim/cda/mesh.h"

#include <cstddef>

namespace ncsim::exporter {

/// Takes edges shorter than `least_mm` and triangles lower than that out of a closed mesh, as far
/// as what hangs together does not change: the ends of a short edge become one vertex; the longest
/// edge of a low triangle is bent to the vertex opposite. Vertices are moved onto others, by less
/// than twice `least_mm` altogether, and left unused. Shells smaller than that vanish. The mesh
/// stays closed. Where `least_mm` is 0, nothing happens. Whether anything did. Low triangles are
/// looked for by `threads`, 0: as many as the machine has. Expected O(n log n).
bool remove_slivers(cda::TriangleMesh& mesh, double least_mm, std::size_t threads = 1);

}  // namespace ncsim::exporter
