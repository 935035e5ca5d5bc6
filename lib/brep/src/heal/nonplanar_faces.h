// SPDX-License-Identifier: GPL-3.0-or-later
//
// Facets whose corners have been moved off their plane.
#pragma once

#include "ncsim/brep/part.h"

#include <cstdint>
#include <vector>

namespace ncsim::brep {

/// True if a planar face with straight edges only has a corner that is off the plane by more than
/// polyhedra are: 1e-4 mm.
bool is_nonplanar(const Part& part, const Face& face);

/// Makes facets planar for which is_nonplanar() is true. If all corners of a facet are within 1e-4
/// mm of the mean plane of the corners, the facet gets this plane. Otherwise the facet is divided
/// into triangles by a constrained Delaunay triangulation of the projection on the old plane.
/// Connected triangles with all corners in the old plane stay a single face in this plane; each
/// remaining triangle becomes a face in the plane of its corners. The pieces together have the same
/// projection as the facet. A facet whose loops cross in projection stays unchanged. New faces are
/// appended to the part, and to the shell of the facet.
/// Returns: for each new face, the number of the facet that was divided.
/// Cost: O(n log n) for n edges; O(n) if no facet is nonplanar.
std::vector<std::uint32_t> triangulate_nonplanar_faces(Part& part);

}  // namespace ncsim::brep
