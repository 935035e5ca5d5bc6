// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances of the surface of a part from its design, for colours.
#pragma once

#include "ncsim/base/triangle_mesh.h"
#include "ncsim/simulation/checked.h"
#include "ncsim/simulation/design_check.h"

namespace ncsim::simulation {

/// Measures `part` (mm, W) against `design`. Edges are halved, at most to 1/1000 of the size of the
/// part, until the distance is linear along each edge within half of the tolerance. Places between
/// the measured points may deviate by more.
/// Requires: `part` and the design are not empty.
/// Returns: a mesh with the vertices of `part` first, and with its faces.
/// Cost: two queries of the design for each corner of the result.
DeviationMesh deviation_mesh(const TriangleMesh& part, const Design& design);

}  // namespace ncsim::simulation
