// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removes the half of a closed mesh in front of a plane.
#pragma once

#include "ncsim/base/triangle_mesh.h"

#include <cstdint>
#include <vector>

namespace ncsim::mesh {

/// Plane that cuts bodies open. Points with normal · x > offset are removed; mm, W.
struct CutPlane {
    Vec3 normal;  ///< Unit vector towards the removed half.
    double offset = 0.0;
};

/// Remaining half of a mesh.
struct OpenMesh {
    /// Triangles of the old faces, with the old vertices first, then triangles of the cut, whose
    /// `face` is the number of old faces.
    TriangleMesh mesh;
    /// For each triangle of an old face, the index of the old triangle that contains it.
    std::vector<std::uint32_t> old_triangle;
};

/// Returns the half of `mesh` behind `plane`. Points within 1 nm of the plane count as behind the
/// plane, so a face in the plane stays if it looks at the removed half. `faces` is the number of
/// faces of `mesh`.
/// Requires: each directed edge of `mesh` has one partner in the opposite direction.
/// Guarantees: the result is closed up to rounding.
/// Cost: O(n + k log k) for n triangles, k of which meet the plane.
OpenMesh open_mesh(const TriangleMesh& mesh, std::uint32_t faces, const CutPlane& plane);

}  // namespace ncsim::mesh
