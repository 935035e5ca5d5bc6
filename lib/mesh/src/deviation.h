// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distance between two surfaces.
#pragma once

#include "ncsim/base/triangle_mesh.h"

namespace ncsim::mesh {

/// Returns the largest distance, in mm, from a corner or the middle of a triangle of either mesh to
/// the other mesh: the Hausdorff distance, sampled at these points. Infinite if exactly one mesh is
/// empty.
/// Cost: O(n log n) expected.
double deviation(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace ncsim::mesh
