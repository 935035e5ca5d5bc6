// SPDX-License-Identifier: GPL-3.0-or-later
//
// The results of simplify() and join_faces().
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/cda/boundary.h"
#include "ncsim/cda/triangulate.h"

#include <vector>

namespace ncsim::mesh {

/// A boundary with fewer faces.
struct JoinedFaces {
    /// The simplified boundary. The `origin` of a face is the smallest origin of the faces that
    /// were joined, or, if simplify() kept program lines apart, that of the largest face. Each
    /// vertex is used.
    cda::Boundary boundary;
    /// For each face the origins of the faces that were joined, ascending, without repetition.
    std::vector<std::vector<cda::Origin>> origins;
};

/// Boundary with fewer faces, with triangles and deviation.
struct Simplified : JoinedFaces {
    /// Measured deviation in mm, at most the tolerance: the largest distance from a corner or the
    /// middle of a triangle of either surface to the opposite surface. Shells that vanished are not
    /// measured.
    double deviation_mm = 0.0;
    /// The triangles of cda::triangulate(boundary).
    TriangleMesh mesh;
};

}  // namespace ncsim::mesh
