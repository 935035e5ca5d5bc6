// SPDX-License-Identifier: GPL-3.0-or-later
//
// Division of faces into triangles, for file formats that support only triangles.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"

#include <cstddef>

namespace ncsim::cda {

/// Divides every face into triangles between the face's vertices; the mesh is closed if the
/// boundary is. The vertices of the boundary come first, in order and unmoved. A few vertices may
/// follow: where edges of a face cross by rounding, and at the middle of diagonals that would
/// otherwise occur twice. `threads`: 0 means one per hardware thread; the mesh does not depend on
/// the number.
/// Cost: expected O(n log n) per face.
TriangleMesh triangulate(const Boundary& boundary, std::size_t threads = 1);

}  // namespace ncsim::cda
