// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangle meshes, for file formats that support only triangles.
#pragma once

#include "ncsim/cda/boundary.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ncsim::cda {

/// A triangle mesh, mm, workpiece frame.
struct TriangleMesh {
    std::vector<Vec3> vertices;
    /// Indices into `vertices`, counter-clockwise seen from outside.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Index of the Boundary face of each triangle.
    std::vector<std::uint32_t> face;
};

/// Divides every face into triangles between the face's vertices; the mesh is closed if the
/// boundary is. The vertices of the boundary come first, in order and unmoved. A few vertices may
/// follow: where edges of a face cross by rounding, and at the middle of diagonals that would
/// otherwise occur twice. `threads`: 0 means one per hardware thread; the mesh does not depend on
/// the number.
/// Cost: expected O(n log n) per face.
TriangleMesh triangulate(const Boundary& boundary, std::size_t threads = 1);

}  // namespace ncsim::cda
