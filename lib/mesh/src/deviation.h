// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distance between two surfaces.
#pragma once

#include "ncsim/base/triangle_mesh.h"

namespace ncsim::mesh {

/// Returns the largest distance from a corner or the middle of a triangle of `a` to `b`, or of `b`
/// to `a`, mm: the Hausdorff distance, sampled at these points. Infinite if exactly one of the
/// meshes is empty.
/// Cost: O(n log n) expected.
double deviation(const TriangleMesh& a, const TriangleMesh& b);

}  // namespace ncsim::mesh
